//! Kinds of ends: what is special where a patch begins and ends, known from its control data and not measured.
//!
//! A rail may be a point (an apex), a rail may stand still at an end (a *retracted handle*: its first control points
//! coincide, so its speed falls to zero there although its tangent is continuous), and the rails may meet in a point (a
//! *tip*: a ruling of no length, at the end of a gore, at the head of a sail). These are found by comparing control
//! points, exactly; nothing evaluated is compared with zero.

/// How a rail begins or ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RailEnd {
    /// With a speed.
    #[default]
    Ordinary,
    /// Standing still: its speed has a zero of this order at least.
    Still {
        /// How many control points beyond the first coincide with it.
        order: usize,
    },
}

/// What a rail is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RailKind {
    /// One point: an apex.
    Point,
    /// A curve.
    Curve {
        /// Its start and its end.
        ends: [RailEnd; 2],
        /// Whether it ends where it starts.
        closed: bool,
    },
}

impl Default for RailKind {
    fn default() -> Self {
        Self::Curve {
            ends: [RailEnd::Ordinary; 2],
            closed: false,
        }
    }
}

impl RailKind {
    /// The kind of a curve with these control points.
    ///
    /// ```
    /// use torse_geometry::surface::{RailEnd, RailKind};
    /// let retracted = [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [6.0, 4.0, 0.0], [9.0, 0.0, 0.0]];
    /// let ends = [RailEnd::Still { order: 1 }, RailEnd::Ordinary];
    /// assert_eq!(RailKind::from_points(&retracted), RailKind::Curve { ends, closed: false });
    /// assert_eq!(RailKind::from_points(&[[1.0; 3]; 4]), RailKind::Point);
    /// ```
    #[must_use]
    pub fn from_points<P: PartialEq>(points: &[P]) -> Self {
        let (Some(first), Some(last)) = (points.first(), points.last()) else {
            return Self::default();
        };
        let equal =
            |to: &P, list: &mut dyn Iterator<Item = &P>| list.take_while(|p| *p == to).count();
        let from_start = equal(first, &mut points.iter());
        if from_start == points.len() {
            return Self::Point;
        }
        let from_end = equal(last, &mut points.iter().rev());
        let end = |same: usize| match same {
            0 | 1 => RailEnd::Ordinary,
            more => RailEnd::Still { order: more - 1 },
        };
        Self::Curve {
            ends: [end(from_start), end(from_end)],
            closed: first == last,
        }
    }

    /// Whether the rail is a point, or stands still at its start (0) or its end (1).
    fn is_still(self, end: usize) -> bool {
        match self {
            Self::Point => true,
            Self::Curve { ends, .. } => ends.get(end).is_some_and(|end| *end != RailEnd::Ordinary),
        }
    }
}

/// What the first or the last ruling of a patch is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RulingEnd {
    /// A line at which at least one rail has a speed.
    #[default]
    Ordinary,
    /// A line at which both rails stand still.
    Still,
    /// A point, in which both rails meet.
    Tip,
}

/// The kinds of both rails and of the first and the last ruling of a patch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct EndKinds {
    rails: [RailKind; 2],
    rulings: [RulingEnd; 2],
}

impl EndKinds {
    /// Of a patch with these rails, which meet in a point at its first, its last ruling or at none.
    #[must_use]
    pub fn new(rails: [RailKind; 2], tips: [bool; 2]) -> Self {
        let ruling = |end: usize| {
            if tips[end] {
                RulingEnd::Tip
            } else if rails.iter().all(|rail| rail.is_still(end)) {
                RulingEnd::Still
            } else {
                RulingEnd::Ordinary
            }
        };
        Self {
            rails,
            rulings: [ruling(0), ruling(1)],
        }
    }

    /// Of a patch that takes an inner part of these curves, or all of them: whether they are closed is all that is
    /// known.
    #[must_use]
    pub fn of_ordinary(curves: [RailKind; 2]) -> Self {
        let rails = curves.map(|curve| match curve {
            RailKind::Point => RailKind::Point,
            RailKind::Curve { closed, .. } => RailKind::Curve {
                ends: [RailEnd::Ordinary; 2],
                closed,
            },
        });
        Self {
            rails,
            rulings: [RulingEnd::Ordinary; 2],
        }
    }

    /// The rails.
    #[must_use]
    pub fn rails(&self) -> [RailKind; 2] {
        self.rails
    }

    /// The first and the last ruling.
    #[must_use]
    pub fn rulings(&self) -> [RulingEnd; 2] {
        self.rulings
    }

    /// Which rails are a point.
    #[must_use]
    pub fn apexes(&self) -> [bool; 2] {
        self.rails.map(|rail| rail == RailKind::Point)
    }

    /// Whether both rails are curves that end where they start.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        let closed = |rail: &RailKind| matches!(rail, RailKind::Curve { closed: true, .. });
        self.rails.iter().all(closed)
    }

    /// Those of the part of a patch that keeps its start, its end, both or none.
    #[must_use]
    pub fn part(&self, kept: [bool; 2]) -> Self {
        let rails = self.rails.map(|rail| match rail {
            RailKind::Point => RailKind::Point,
            RailKind::Curve { ends, closed } => RailKind::Curve {
                ends: [0, 1].map(|end| {
                    if kept[end] {
                        ends[end]
                    } else {
                        RailEnd::Ordinary
                    }
                }),
                closed: closed && kept == [true; 2],
            },
        });
        let rulings = [0, 1].map(|end| {
            if kept[end] {
                self.rulings[end]
            } else {
                RulingEnd::Ordinary
            }
        });
        Self { rails, rulings }
    }
}
