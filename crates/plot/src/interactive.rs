//! Pictures that follow sliders, as data for a viewer: no drawing is done here.
//!
//! A point that is a polynomial in shape parameters, `P(mu, nu) = sum over monomials of mu^a nu^b N_ab`, is
//! known everywhere from its coefficients `N_ab`. So a curve or a surface that has been sampled once for each
//! monomial (its *nets*) is redrawn for any slider values by multiplying and adding: a viewer needs no formula
//! of any basis.

use std::collections::BTreeSet;

use thiserror::Error;

use crate::{colour::Colour, error::FigureError, ink::label};

/// Most sliders of one picture.
pub const MAX_SLIDERS: usize = 8;

/// Highest exponent of a slider value in a monomial.
pub const HIGHEST_EXPONENT: u32 = 24;

/// Most points of all nets together, so that a page which carries them stays small.
pub const MAX_POINTS: usize = 60_000;

/// A quantity that the reader sets.
#[derive(Debug, Clone, PartialEq)]
pub struct Slider {
    /// The name of the parameter in formulas, for instance `mu`; unique in the picture.
    pub name: String,
    /// What stands beside the slider, in the [label language](crate#labels), for instance `$\mu$`.
    pub label: String,
    /// Least value.
    pub least: f64,
    /// Greatest value, more than the least.
    pub greatest: f64,
    /// The value at first, between least and greatest.
    pub start: f64,
    /// The distance of neighbouring values: positive and at most `greatest - least`.
    pub step: f64,
}

/// The space of the points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ambient {
    /// In a plane: the third coordinate of every point is zero.
    Plane,
    /// In space.
    Space,
}

/// How the points of a part are connected.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// A shaded patch, points row by row.
    Surface {
        /// Points in a row, at least 2.
        columns: usize,
        /// Rows, at least 2.
        rows: usize,
    },
    /// A control net: segments along rows and columns, vertices marked; points row by row.
    Net {
        /// Points in a row, at least 2.
        columns: usize,
        /// Rows, at least 2.
        rows: usize,
    },
    /// A smooth curve through at least 2 points.
    Curve,
    /// A control polygon: segments between at least 2 neighbours, vertices marked.
    Polygon,
    /// Single points, at least 1.
    Points,
}

/// One object of the picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// What it is called in the legend, in the [label language](crate#labels); empty for no entry.
    pub label: String,
    /// Its colour.
    pub colour: Colour,
    /// How its points are connected.
    pub shape: Shape,
    /// For each monomial of the picture, in its order, the coefficients of all points.
    pub nets: Vec<Vec<[f64; 3]>>,
}

/// A picture that follows sliders.
///
/// ```
/// use torse_plot::{Ambient, Interactive, Part, Shape, Slider, palette};
///
/// // The segment from the origin to (1, mu, 0), so: (0, 0, 0), (1, 0, 0) and mu times (0, 0, 0), (0, 1, 0).
/// let slider = Slider {
///     name: "mu".into(),
///     label: "$\\mu$".into(),
///     least: -1.0,
///     greatest: 1.0,
///     start: 0.5,
///     step: 0.01,
/// };
/// let segment = Part {
///     label: "segment".into(),
///     colour: palette(0),
///     shape: Shape::Curve,
///     nets: vec![vec![[0.0; 3], [1.0, 0.0, 0.0]], vec![[0.0; 3], [0.0, 1.0, 0.0]]],
/// };
/// let picture = Interactive::new(vec![slider], vec![vec![0], vec![1]], Ambient::Plane, vec![segment])?;
/// let segment = &picture.parts()[0];
/// assert_eq!(picture.points(segment, &[0.5]), [[0.0; 3], [1.0, 0.5, 0.0]]);
/// # Ok::<(), torse_plot::InteractiveError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Interactive {
    sliders: Vec<Slider>,
    monomials: Vec<Vec<u32>>,
    ambient: Ambient,
    parts: Vec<Part>,
    view: [f64; 2],
}

/// The usual direction of a view: azimuth and elevation in degrees.
const USUAL_VIEW: [f64; 2] = [-60.0, 25.0];

/// Why an interactive picture was refused.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum InteractiveError {
    /// Nothing to set, nothing to see, or too much of either.
    #[error("{got} {what} given, from {least} to {most} allowed")]
    Count {
        /// What was counted.
        what: &'static str,
        /// How many were given.
        got: usize,
        /// Least number allowed.
        least: usize,
        /// Greatest number allowed.
        most: usize,
    },
    /// A slider's name is empty or taken by one before it.
    #[error("slider {slider}: the name `{name}` is empty or taken")]
    Name {
        /// The slider, from 0.
        slider: usize,
        /// Its name.
        name: String,
    },
    /// A slider's numbers are not finite or out of order.
    #[error(
        "slider {slider}: least {least}, start {start}, greatest {greatest}, step {step} are not a range"
    )]
    Range {
        /// The slider, from 0.
        slider: usize,
        /// Its least value.
        least: f64,
        /// Its greatest value.
        greatest: f64,
        /// Its value at first.
        start: f64,
        /// Its step.
        step: f64,
    },
    /// The exponents of a monomial do not match the sliders, are too high, or occur twice.
    #[error(
        "monomial {monomial}: the exponents {exponents:?} are too many, too few, too high or repeated"
    )]
    Monomial {
        /// The monomial, from 0.
        monomial: usize,
        /// Its exponents.
        exponents: Vec<u32>,
    },
    /// The number of nets of a part differs from that of the monomials.
    #[error("part {part}: {got} nets given for {expected} monomials")]
    Nets {
        /// The part, from 0.
        part: usize,
        /// How many nets it has.
        got: usize,
        /// How many monomials there are.
        expected: usize,
    },
    /// A net has the wrong number of points for the part's shape, or another than the part's first net.
    #[error("part {part}, net {net}: {got} points do not make a {shape:?}")]
    Points {
        /// The part, from 0.
        part: usize,
        /// The net, from 0.
        net: usize,
        /// How many points it has.
        got: usize,
        /// What they should be.
        shape: Shape,
    },
    /// A coordinate is not finite, or not zero in a plane picture.
    #[error("part {part}, net {net}, point {point}: {value:?} is not finite or leaves the plane")]
    Coordinate {
        /// The part, from 0.
        part: usize,
        /// The net, from 0.
        net: usize,
        /// The point, from 0.
        point: usize,
        /// Its coordinates.
        value: [f64; 3],
    },
    /// A piece of a developable that cannot be shown.
    #[error("piece {piece}: {problem}")]
    Piece {
        /// The piece, from 0.
        piece: usize,
        /// What is wrong with it.
        problem: &'static str,
    },
    /// A label that does not parse.
    #[error(transparent)]
    Label(#[from] FigureError),
}

impl Interactive {
    /// A picture from its data: `monomials` are exponents of the slider values, in the order of the sliders.
    ///
    /// # Errors
    ///
    /// [`InteractiveError`] names the slider, monomial, part, net and point at fault.
    pub fn new(
        sliders: Vec<Slider>,
        monomials: Vec<Vec<u32>>,
        ambient: Ambient,
        parts: Vec<Part>,
    ) -> Result<Self, InteractiveError> {
        count("sliders", sliders.len(), 1, MAX_SLIDERS)?;
        count("monomials", monomials.len(), 1, MAX_POINTS)?;
        count("parts", parts.len(), 1, MAX_POINTS)?;
        let nets = parts.iter().flat_map(|part| &part.nets);
        count("points", nets.map(Vec::len).sum(), 1, MAX_POINTS)?;
        check_sliders(&sliders)?;
        check_monomials(&monomials, sliders.len())?;
        for (number, part) in parts.iter().enumerate() {
            check_part(number, part, monomials.len(), ambient)?;
        }
        Ok(Interactive {
            sliders,
            monomials,
            ambient,
            parts,
            view: USUAL_VIEW,
        })
    }

    /// Sets the initial direction of the view: azimuth and elevation in degrees, as in
    /// [`Camera::Angles`](crate::Camera::Angles). NaN is ignored.
    #[must_use]
    pub fn seen_from(mut self, view: [f64; 2]) -> Self {
        if view.iter().all(|angle| angle.is_finite()) {
            self.view = view;
        }
        self
    }

    /// Azimuth and elevation of the first view, in degrees.
    #[must_use]
    pub fn view(&self) -> [f64; 2] {
        self.view
    }

    /// Returns the sliders.
    #[must_use]
    pub fn sliders(&self) -> &[Slider] {
        &self.sliders
    }

    /// The exponents of each monomial, in the order of the sliders.
    #[must_use]
    pub fn monomials(&self) -> &[Vec<u32>] {
        &self.monomials
    }

    /// Returns the space of the points.
    #[must_use]
    pub fn ambient(&self) -> Ambient {
        self.ambient
    }

    /// Returns the visible parts.
    #[must_use]
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// Returns the points of `part` at the slider `values`, in the order of the sliders; a missing value is 0.
    #[must_use]
    pub fn points(&self, part: &Part, values: &[f64]) -> Vec<[f64; 3]> {
        let mut points = vec![[0.0; 3]; part.nets.first().map_or(0, Vec::len)];
        for (exponents, net) in self.monomials.iter().zip(&part.nets) {
            let power = |(slider, &exponent): (usize, &u32)| {
                let value = values.get(slider).copied().unwrap_or(0.0);
                (0..exponent).map(|_| value).product::<f64>()
            };
            let weight: f64 = exponents.iter().enumerate().map(power).product();
            for (point, coefficient) in points.iter_mut().zip(net) {
                for (sum, term) in point.iter_mut().zip(coefficient) {
                    *sum += weight * term;
                }
            }
        }
        points
    }
}

pub(crate) fn count(
    what: &'static str,
    got: usize,
    least: usize,
    most: usize,
) -> Result<(), InteractiveError> {
    match (least..=most).contains(&got) {
        true => Ok(()),
        false => Err(InteractiveError::Count {
            what,
            got,
            least,
            most,
        }),
    }
}

pub(crate) fn check_sliders(sliders: &[Slider]) -> Result<(), InteractiveError> {
    let mut names = BTreeSet::new();
    for (number, slider) in sliders.iter().enumerate() {
        if slider.name.is_empty() || !names.insert(&slider.name) {
            return Err(InteractiveError::Name {
                slider: number,
                name: slider.name.clone(),
            });
        }
        let &Slider {
            least,
            greatest,
            start,
            step,
            ..
        } = slider;
        let width = greatest - least;
        let ordered = least < greatest && (least..=greatest).contains(&start);
        if !(ordered && width.is_finite() && step > 0.0 && step <= width) {
            return Err(InteractiveError::Range {
                slider: number,
                least,
                greatest,
                start,
                step,
            });
        }
        label::parse(&slider.label)?;
    }
    Ok(())
}

fn check_monomials(monomials: &[Vec<u32>], sliders: usize) -> Result<(), InteractiveError> {
    let mut seen = BTreeSet::new();
    for (monomial, exponents) in monomials.iter().enumerate() {
        let small = exponents
            .iter()
            .all(|&exponent| exponent <= HIGHEST_EXPONENT);
        if exponents.len() != sliders || !small || !seen.insert(exponents) {
            return Err(InteractiveError::Monomial {
                monomial,
                exponents: exponents.clone(),
            });
        }
    }
    Ok(())
}

fn check_part(
    number: usize,
    part: &Part,
    monomials: usize,
    ambient: Ambient,
) -> Result<(), InteractiveError> {
    label::parse(&part.label)?;
    if part.nets.len() != monomials {
        return Err(InteractiveError::Nets {
            part: number,
            got: part.nets.len(),
            expected: monomials,
        });
    }
    let first = part.nets.first().map_or(0, Vec::len);
    for (net, points) in part.nets.iter().enumerate() {
        if points.len() != first || !part.shape.takes(points.len()) {
            return Err(InteractiveError::Points {
                part: number,
                net,
                got: points.len(),
                shape: part.shape,
            });
        }
        let inside = |value: &[f64; 3]| {
            value.iter().all(|number| number.is_finite())
                && (ambient == Ambient::Space || value[2] == 0.0)
        };
        if let Some(point) = points.iter().position(|value| !inside(value)) {
            return Err(InteractiveError::Coordinate {
                part: number,
                net,
                point,
                value: points.get(point).copied().unwrap_or_default(),
            });
        }
    }
    Ok(())
}

impl Shape {
    /// Whether `count` points make such a shape.
    fn takes(self, count: usize) -> bool {
        match self {
            Shape::Surface { columns, rows } | Shape::Net { columns, rows } => {
                columns >= 2 && rows >= 2 && columns.checked_mul(rows) == Some(count)
            }
            Shape::Curve | Shape::Polygon => count >= 2,
            Shape::Points => count >= 1,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn slider(name: &str) -> Slider {
        Slider {
            name: name.to_owned(),
            label: format!("${name}$"),
            least: -1.0,
            greatest: 1.0,
            start: 0.0,
            step: 0.125,
        }
    }

    fn part(nets: Vec<Vec<[f64; 3]>>, shape: Shape) -> Part {
        Part {
            label: "curve $r(t)$".to_owned(),
            colour: Colour::INK,
            shape,
            nets,
        }
    }

    fn segment(nets: usize) -> Part {
        part(vec![vec![[0.0; 3], [1.0, 2.0, 0.0]]; nets], Shape::Curve)
    }

    fn refused(sliders: Vec<Slider>, monomials: Vec<Vec<u32>>, part: Part) -> InteractiveError {
        Interactive::new(sliders, monomials, Ambient::Plane, vec![part]).unwrap_err()
    }

    #[test]
    fn sliders_without_name_or_range_are_named() {
        let twice = vec![slider("a"), slider("a")];
        let monomials = vec![vec![0, 0]];
        assert_eq!(
            refused(twice, monomials, segment(1)),
            InteractiveError::Name {
                slider: 1,
                name: "a".to_owned()
            }
        );
        for wrong in [
            Slider {
                least: 1.0,
                ..slider("a")
            },
            Slider {
                start: f64::NAN,
                ..slider("a")
            },
            Slider {
                greatest: f64::INFINITY,
                ..slider("a")
            },
            Slider {
                step: 0.0,
                ..slider("a")
            },
            Slider {
                step: 3.0,
                ..slider("a")
            },
        ] {
            let error = refused(vec![wrong], vec![vec![0]], segment(1));
            assert!(
                matches!(error, InteractiveError::Range { slider: 0, .. }),
                "{error}"
            );
        }
    }

    #[test]
    fn monomials_have_one_exponent_a_slider_and_stand_once() {
        for monomials in [
            vec![vec![]],
            vec![vec![0], vec![0]],
            vec![vec![25]],
            vec![vec![0, 1]],
        ] {
            let nets = monomials.len();
            let error = refused(vec![slider("a")], monomials, segment(nets));
            assert!(
                matches!(error, InteractiveError::Monomial { .. }),
                "{error}"
            );
        }
    }

    #[test]
    fn nets_fit_their_monomials_their_shape_and_the_plane() {
        let wrong = |part| refused(vec![slider("a")], vec![vec![0], vec![1]], part);
        assert!(matches!(
            wrong(segment(1)),
            InteractiveError::Nets {
                got: 1,
                expected: 2,
                ..
            }
        ));
        let uneven = part(vec![vec![[0.0; 3]; 2], vec![[0.0; 3]; 3]], Shape::Curve);
        assert!(matches!(
            wrong(uneven),
            InteractiveError::Points { net: 1, got: 3, .. }
        ));
        let shape = Shape::Surface {
            columns: usize::MAX,
            rows: 2,
        };
        let huge = part(vec![vec![[0.0; 3]; 4]; 2], shape);
        assert!(matches!(
            wrong(huge),
            InteractiveError::Points { got: 4, .. }
        ));
        let raised = part(vec![vec![[0.0; 3], [0.0, 0.0, 1.0]]; 2], Shape::Curve);
        assert!(matches!(
            wrong(raised),
            InteractiveError::Coordinate {
                net: 0,
                point: 1,
                ..
            }
        ));
        let mut label = segment(2);
        label.label = "$x_".to_owned();
        assert!(matches!(wrong(label), InteractiveError::Label(_)));
    }

    #[test]
    fn too_many_points_are_refused() {
        let many = part(vec![vec![[0.0; 3]; MAX_POINTS + 1]], Shape::Points);
        assert!(matches!(
            refused(vec![slider("a")], vec![vec![0]], many),
            InteractiveError::Count { what: "points", .. }
        ));
    }

    proptest! {
        #[test]
        fn points_are_the_polynomial_with_the_nets_as_coefficients(
            nets in prop::collection::vec(prop::array::uniform3(-9.0..9.0), 3),
            a in -1.0..1.0, b in -1.0..1.0,
        ) {
            let monomials = vec![vec![0, 0], vec![2, 1], vec![0, 3]];
            let point = part(nets.iter().map(|net| vec![*net]).collect(), Shape::Points);
            let sliders = vec![slider("a"), slider("b")];
            let picture =
                Interactive::new(sliders, monomials, Ambient::Space, vec![point]).unwrap();
            let found = picture.points(&picture.parts()[0], &[a, b])[0];
            for k in 0..3 {
                let expected = nets[0][k] + a * a * b * nets[1][k] + b * b * b * nets[2][k];
                prop_assert!((found[k] - expected).abs() < 1e-12);
            }
        }
    }
}
