//! How far evaluation is from what the machine can do, as one table of ratios from one process.
//!
//! Each line is a kernel and what it is measured against: plain stores of the same bytes, the evaluation of the
//! same rulings, or the same work on one thread. All kernels take turns, eleven times, into buffers that are
//! reused; the table shows the least and the middle time of each, and the middle of the eleven ratios. On a busy
//! machine the least times are the ones to trust, on a quiet one both say the same. Run it with
//! `cargo bench -p torse-geometry --bench limits`.
//!
//! # What a point costs
//!
//! Degree three, for each parameter: additions, multiplications and divisions of doubles, counted in the source. Nothing
//! is fused, so that the values are those of every other machine. Comparisons, loads and stores are not counted.
//!
//! | part | Bernstein | trigonometric |
//! |---|---:|---:|
//! | sine and cosine of a quarter turn, by their Taylor polynomials | 0 | 39 |
//! | three seeds | 5 | 10 |
//! | blend to degree three | 9 | 9 |
//! | sum of four points of three coordinates | 21 | 21 |
//! | **a point of a curve** | **35** | **79** |
//! | the same with planes of four coordinates | 42 | 86 |
//! | slopes of the seeds, of their blend and of the plane | 53 | 63 |
//! | vector products, square and quotient of the ruling | 35 | 35 |
//! | powers of two back to the planes as given | 18 | 18 |
//! | **a ruling** | **148** | **202** |
//!
//! A register of 256 bits holds four doubles and two such operations start in a cycle, so a trigonometric point
//! takes ten cycles at least and its 24 bytes about as long to store; with registers of 512 bits it takes half.
//!
//! # What a pattern costs
//!
//! A ruling of a pattern costs about three evaluations of a ruling with its derivative between cubic rails, and less than
//! two on an envelope of planes, where the evaluation is the greater part. The operations for each of many rulings:
//!
//! | part | operations |
//! |---|---:|
//! | a sixth of an evaluation: 21 of them for 128 rulings, on intervals of their own | a sixth of the evaluation |
//! | directions, speeds and angles of these | 30 |
//! | 23 polynomials of degree 16 through 17 of these, a transform of 17 x 17 halved by its symmetry | 55 |
//! | 14 of the polynomials at the ruling, 3 halfway to the next, eight rulings side by side | 580 |
//! | their rows of Chebyshev polynomials | 90 |
//! | the bend: a vector product, a square root, an arc tangent | 60 |
//!
//! The outline (arcs through points of the polynomials, each bounded by products of polynomials) costs as much for a
//! few rulings as for many. With fewer than about 300 it is the greater part.
//!
//! # What a second thread gains
//!
//! Samples, interpolants, rulings and bends are shared, the two rails are fitted side by side. One after the other go the
//! placing of the intervals, the outline, its crossings, the memory of the answer: about a ninth of the work, so 1.8 is
//! the most of two threads. What is shared is done in four to six turns, and to wake a thread for each takes as long
//! as some tens of rulings: the gain shows with ten thousand rulings better than with one. A machine with other work
//! shows none. The lines of arithmetic alone say what two threads gain on the machine at hand for work of the same length
//! that shares nothing at all.

#![allow(clippy::expect_used, reason = "a benchmark on known good data")]
#![allow(clippy::print_stdout, reason = "the table is what it is for")]

use rayon::ThreadPoolBuilder;
use std::cell::RefCell;
use std::hint::black_box;
use std::time::{Duration, Instant};
use torse_geometry::batch::{GridEvaluator, ruled_grid_into};
use torse_geometry::developable::certify;
use torse_geometry::pattern::Unrolling;
use torse_geometry::{
    Basis, Bernstein, Curve, EnvelopingPatch, Gbt, PatchBounds, PlaneFamily, Rails, RuledSurface,
    TensorSurface,
};

const ROUNDS: usize = 11;
const COUNT: usize = 1_000_000;
const SIDE: usize = 1000;
const RULINGS: [usize; 3] = [1001, 10_001, 60_001];

/// A kernel, and the line it is compared with.
struct Line<'a> {
    name: &'static str,
    against: usize,
    elements: usize,
    run: Box<dyn FnMut() + 'a>,
    times: Vec<Duration>,
}

#[derive(Default)]
struct Table<'a>(Vec<Line<'a>>);

impl<'a> Table<'a> {
    /// Adds a line that is compared with line `against`, or with itself; gives its number.
    fn add(
        &mut self,
        name: &'static str,
        against: Option<usize>,
        elements: usize,
        run: impl FnMut() + 'a,
    ) -> usize {
        let number = self.0.len();
        self.0.push(Line {
            name,
            against: against.unwrap_or(number),
            elements,
            run: Box::new(run),
            times: Vec::with_capacity(ROUNDS),
        });
        number
    }

    fn print(&mut self) {
        for _ in 0..ROUNDS {
            for line in &mut self.0 {
                let start = Instant::now();
                (line.run)();
                line.times.push(start.elapsed());
            }
        }
        println!(
            "{:<42} {:>10} {:>10} {:>8} {:>8}",
            "", "least", "middle", "least", "middle"
        );
        println!(
            "{:<42} {:>10} {:>10} {:>8} {:>8}",
            "", "ns each", "ns each", "ratio", "ratio"
        );
        for line in &self.0 {
            let base = &self.0[line.against].times;
            let each = |t: f64| t * 1e9 / line.elements as f64;
            let seconds: Vec<f64> = line.times.iter().map(Duration::as_secs_f64).collect();
            let ratios = line
                .times
                .iter()
                .zip(base)
                .map(|(t, b)| t.as_secs_f64() / b.as_secs_f64());
            let (least, least_base) = (line.times.iter().min(), base.iter().min());
            let least = least.expect("rounds").as_secs_f64();
            println!(
                "{:<42} {:>10.2} {:>10.2} {:>8.2} {:>8.2}",
                line.name,
                each(least),
                each(middle(seconds)),
                least / least_base.expect("rounds").as_secs_f64(),
                middle(ratios.collect()),
            );
        }
    }
}

fn middle(mut list: Vec<f64>) -> f64 {
    list.sort_by(f64::total_cmp);
    list[list.len() / 2]
}

fn parameters(count: usize) -> Vec<f64> {
    (0..count).map(|i| i as f64 / (count - 1) as f64).collect()
}

fn curve<B: Basis<f64>>(basis: B) -> Curve<B, f64, 3> {
    let points = (0..4).map(|i| [i as f64, ((i * 7) % 5) as f64, ((i * 3) % 4) as f64]);
    Curve::new(basis, points.collect()).expect("control points")
}

fn family<B: Basis<f64>>(basis: B) -> PlaneFamily<B, f64> {
    let planes = vec![
        [1., 0., 0.2, 3.],
        [0.5, 1., 0.1, 2.],
        [0., 1., 0.5, 4.],
        [-1., 0.3, 0.1, 5.],
    ];
    PlaneFamily::new(basis, planes).expect("planes in general position")
}

fn surface<B: Basis<f64>>(basis: &B) -> TensorSurface<B, B, f64> {
    let height = |i: usize, j: usize| ((i * 7 + j * 13) % 5) as f64 * 0.3;
    let row = |i| (0..4).map(|j| [i as f64, j as f64, height(i, j)]).collect();
    TensorSurface::new(basis.clone(), basis.clone(), (0..4).map(row).collect()).expect("a net")
}

fn points() {
    let gbt = Gbt::new(0.5, -0.25).expect("shape parameters in range");
    let (xs, side) = (parameters(COUNT), parameters(SIDE));
    let (polynomial, trigonometric) = (curve(Bernstein), curve(gbt));
    let (flat, round) = (surface(&Bernstein), surface(&gbt));
    let sheet =
        EnvelopingPatch::new(family(gbt), PatchBounds::Range([-1.0, 1.0])).expect("a range");
    let out = RefCell::new(vec![[0.0; 3]; COUNT]);
    let mut table = Table::default();
    let stores = table.add("plain stores of 24 bytes", None, COUNT, || {
        out.borrow_mut().fill(black_box([1.5, 2.5, 3.5]));
    });
    table.add("curve, Bernstein", Some(stores), COUNT, || {
        let curve = black_box(&polynomial);
        curve
            .points_into(&xs, &mut out.borrow_mut())
            .expect("points");
    });
    table.add("curve, trigonometric", Some(stores), COUNT, || {
        let curve = black_box(&trigonometric);
        curve
            .points_into(&xs, &mut out.borrow_mut())
            .expect("points");
    });
    table.add("grid, Bernstein", Some(stores), COUNT, || {
        let grid = GridEvaluator::new(black_box(&flat), &side, &side).expect("bases");
        grid.fill(&mut out.borrow_mut()).expect("points");
    });
    table.add("grid, trigonometric", Some(stores), COUNT, || {
        let grid = GridEvaluator::new(black_box(&round), &side, &side).expect("bases");
        grid.fill(&mut out.borrow_mut()).expect("points");
    });
    table.add("grid of a developable", Some(stores), COUNT, || {
        ruled_grid_into(black_box(&sheet), &side, &side, &mut out.borrow_mut()).expect("rulings");
    });
    table.print();
}

fn planes() {
    let xs = parameters(COUNT);
    let gbt = Gbt::new(0.5, 0.5).expect("shape parameters in range");
    let (polynomial, trigonometric) = (family(Bernstein), family(gbt));
    let out = RefCell::new(vec![[0.0; 4]; COUNT]);
    let mut table = Table::default();
    let stores = table.add("plain stores of 32 bytes", None, COUNT, || {
        out.borrow_mut().fill(black_box([1.5, 2.5, 3.5, 4.5]));
    });
    table.add("planes, Bernstein", Some(stores), COUNT, || {
        let family = black_box(&polynomial).curve();
        family
            .points_into(&xs, &mut out.borrow_mut())
            .expect("planes");
    });
    table.add("planes, trigonometric", Some(stores), COUNT, || {
        let family = black_box(&trigonometric).curve();
        family
            .points_into(&xs, &mut out.borrow_mut())
            .expect("planes");
    });
    table.print();
}

fn rulings() {
    let xs = parameters(COUNT);
    let gbt = Gbt::new(0.5, 0.5).expect("shape parameters in range");
    let (polynomial, trigonometric) = (family(Bernstein), family(gbt));
    let one = polynomial.ruling(&0.5).expect("a ruling");
    let out = RefCell::new(vec![one.clone(); COUNT]);
    let mut table = Table::default();
    let stores = table.add("plain stores of 72 bytes", None, COUNT, || {
        let one = black_box(one.clone());
        for slot in out.borrow_mut().iter_mut() {
            slot.clone_from(&one);
        }
    });
    table.add("rulings, Bernstein", Some(stores), COUNT, || {
        let family = black_box(&polynomial);
        family
            .rulings_into(&xs, &mut out.borrow_mut())
            .expect("rulings");
    });
    table.add("rulings, trigonometric", Some(stores), COUNT, || {
        let family = black_box(&trigonometric);
        family
            .rulings_into(&xs, &mut out.borrow_mut())
            .expect("rulings");
    });
    table.print();
}

fn patterns() {
    let rail = |z: f64, r: f64| {
        let basis = Gbt::new(0.25, 0.5).expect("shape parameters in range");
        let points = vec![[r, 0.0, z], [r, r, z], [0.0, 1.5 * r, z], [-r, r, z]];
        Curve::new(basis, points).expect("control points")
    };
    pattern_table("cone", &RuledSurface::new(rail(0.0, 1.0), rail(3.0, 2.0)));
    let gbt = Gbt::new(0.5, 0.5).expect("shape parameters in range");
    let planes = vec![
        [7.0, -7.0, 5.0, 125.0],
        [-7.0, -7.0, 5.0, 120.0],
        [-7.0, 7.0, 5.0, 130.0],
        [7.0, 7.0, 5.0, 125.0],
    ];
    let family = PlaneFamily::new(gbt, planes).expect("planes in general position");
    let cuts = PatchBounds::Planes([[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 1.0, 3.0]]);
    pattern_table(
        "envelope of planes",
        &EnvelopingPatch::new(family, cuts).expect("planes"),
    );
}

/// A patch on one thread and on two, with few rulings and with many.
fn pattern_table(name: &str, patch: &impl Rails<f64>) {
    for rulings in RULINGS {
        thread_table(name, patch, rulings);
    }
}

fn thread_table(name: &str, patch: &impl Rails<f64>, rulings: usize) {
    let xs = parameters(rulings);
    let threads = [1, 2].map(|count| {
        let pool = ThreadPoolBuilder::new().num_threads(count).build();
        pool.expect("threads")
    });
    let [one, two] = &threads;
    let unrolling = Unrolling::within(1e-4).rulings(rulings);
    let unrolled = || black_box(unrolling.measured(black_box(patch)).expect("a developable"));
    let certified = || black_box(certify(black_box(patch), rulings).expect("a patch"));
    // As many operations as unrolling takes, nowhere near the memory: what this machine gains at best by a second thread
    // for so little work.
    let alone = || {
        let half = || black_box(arithmetic(black_box(rulings / 2)));
        rayon::join(half, half)
    };
    let mut table = Table::default();
    println!("{name}, {rulings} rulings");
    table.add("its rulings", None, rulings, || {
        for x in &xs {
            black_box(black_box(patch).ruling_ends(x).expect("a ruling"));
        }
    });
    let base = table.add("its rulings and their derivatives", None, rulings, || {
        for x in &xs {
            black_box(black_box(patch).ends_and_slopes(x).expect("a ruling"));
        }
    });
    table.add("unrolled, one thread", Some(base), rulings, || {
        one.install(unrolled);
    });
    let base = table.add("unrolled, one thread", None, rulings, || {
        one.install(unrolled);
    });
    table.add("unrolled, two threads", Some(base), rulings, || {
        two.install(unrolled);
    });
    let base = table.add("arithmetic alone, one thread", None, rulings, || {
        one.install(alone);
    });
    table.add("arithmetic alone, two threads", Some(base), rulings, || {
        two.install(alone);
    });
    let base = table.add("certified, one thread", None, rulings, || {
        one.install(certified);
    });
    table.add("certified, two threads", Some(base), rulings, || {
        two.install(certified);
    });
    table.print();
}

/// About as many operations as unrolling so many rulings takes, on registers.
fn arithmetic(rulings: usize) -> [f64; 8] {
    let mut values = [0.125; 8];
    for _ in 0..rulings * 100 {
        for value in &mut values {
            *value = *value * 0.75 + 0.125;
        }
    }
    values
}

fn main() {
    points();
    planes();
    rulings();
    patterns();
}
