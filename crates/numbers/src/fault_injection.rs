//! Faults planted on purpose, to see that each is caught.
//!
//! A tool that says "proved" has to show what happens when it errs. Each [`InjectedFault`] names one deliberate mistake of an
//! engine like this one; the place where it would be made asks [`injected`]. They can be made with debug assertions alone, in
//! what tests are built from, and only [`with`] makes one, which nothing but tests calls. In a release the answer is the
//! constant `false` and nothing of them is left in the program.

/// A deliberate mistake.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InjectedFault {
    /// A symbol that is eliminated leaves its declared range behind nowhere.
    RangeForgotten,
    /// The conditions of a proof are dropped.
    ConditionDropped,
    /// An assumption is used with the wrong sign.
    AssumptionReversed,
    /// What is assumed of one symbol bounds it on the wrong side.
    BoundReversed,
    /// A multiple of an assumption enters a certificate of sign with the wrong sign.
    CertificateSign,
    /// Zero or more is taken for more than zero.
    ZeroTakenForPositive,
    /// An index of a sum of symbolic length is left free in the argument of a basis.
    IndexLeftFree,
    /// A basis below the degree of its seeds is taken to be its seeds.
    DegreeBelowSeeds,
    /// An empty sum has a term.
    EmptySumHasTerm,
    /// A derivative is taken after its point is put in.
    ValueBeforeDerivative,
    /// The derivative of a power of the step lacks the factor of the power.
    PowerWithoutFactor,
    /// The derivative of the cosine has the wrong sign.
    CosineRate,
    /// The cosine of a sum of angles has the wrong sign.
    AngleSum,
    /// A determinant is a permanent.
    DeterminantWithoutSigns,
    /// Only the first half of a conjunction is decided.
    SecondHalfIgnored,
    /// A domain whose closed end belongs to it is called empty.
    ClosedEndExcluded,
    /// A counterexample need not satisfy the assumptions.
    WitnessAnywhere,
    /// A decimal agrees when it is one unit of its last place off.
    RoundingTooWide,
    /// A candidate for a correction is not proved.
    CorrectionUnproved,
    /// A coefficient of a determinant is taken for positive on a cell without a look.
    CoefficientUnlooked,
    /// The root of a square is that of which it is the square, whatever its sign.
    RootSignIgnored,
    /// An integral is what its antiderivative is at the upper end.
    LowerEndForgotten,
    /// A product that telescopes ends one factor early.
    LastFactorForgotten,
    /// The checker of proofs reads a difference as a sum.
    DifferenceReadAsSum,
    /// Of several derivatives around a smooth function the highest order counts, not the sum.
    OrdersByMaximum,
    /// A property of a basis does not see what `at` puts in.
    PropertyOutsideScope,
    /// The body of a definition does not see what is moved.
    DefinitionOutsideScope,
    /// The body of a definition sees the index of a sum.
    IndexCaptured,
    /// A left-out argument of a basis is not moved.
    LeftOutNotMoved,
    /// Whether the variable of a derivative occurs in a root is not asked of the seeds of a basis.
    SeedOverlooked,
    /// The denial of `p and q` is `not p and not q`.
    DenialOfBoth,
    /// The second link of a chain compares with the first side.
    ChainFromFirst,
    /// `F''` is differentiated once.
    PrimesOnce,
    /// An integral goes from its upper to its lower end.
    EndsExchanged,
    /// A function is differentiated by its first parameter, whichever is named.
    FirstParameter,
    /// A witness may lie on an open end of its set.
    OpenEndIncluded,
    /// The parser groups differences from the right.
    DifferenceFromTheRight,
    /// A sign binds more tightly than a power.
    SignBeforePower,
    /// The printed digits of a number are not counted.
    DecimalsForgotten,
    /// What is declared further in does not hide what is declared further out.
    OuterDeclarationKept,
    /// The last hypothesis of a claim is not read.
    HypothesisLeftOut,
    /// An open end of an interval is taken for a closed one.
    OpenEndClosed,
    /// The upper end of a root is rounded down.
    RoundedInward,
    /// The term of a sum does not see its index.
    IndexNotSeen,
    /// What `at` moves is read as if nothing were moved.
    MovedNotSeen,
    /// A derivative of a higher order is the first one.
    OrderForgotten,
    /// The factors of the step of a basis change places.
    StepFactorsExchanged,
    /// Premise and conclusion change places.
    ImplicationReversed,
    /// The hyperbolic cosine is made of a difference.
    CoshAsDifference,
    /// An absolute value is the number itself.
    SizeAsItself,
    /// The arguments of a function come in the opposite order.
    ArgumentsExchanged,
    /// A product is read as a sum.
    ProductAsSum,
    /// A printed decimal loses its sign.
    PrintedSignLost,
    /// The points at which a divisor of an elimination vanishes are forgotten.
    CaseForgotten,
    /// The evaluator of trees remembers a value whatever was moved since.
    StaleMemory,
    /// The stream of points makes the same choice always.
    StreamDegenerate,
}

#[cfg(debug_assertions)]
thread_local! {
    static CHOSEN: std::cell::Cell<Option<InjectedFault>> = const { std::cell::Cell::new(None) };
}

/// Whether this mistake is to be made on this thread.
#[cfg(debug_assertions)]
#[must_use]
pub fn injected(fault: InjectedFault) -> bool {
    CHOSEN.get() == Some(fault)
}

/// Whether this mistake is to be made: no.
#[cfg(not(debug_assertions))]
#[inline(always)]
#[must_use]
pub const fn injected(_: InjectedFault) -> bool {
    false
}

/// Makes one mistake, and no other, wherever it can be made while the job is done on this thread.
#[cfg(debug_assertions)]
pub fn with<T>(fault: InjectedFault, job: impl FnOnce() -> T) -> T {
    let before = CHOSEN.replace(Some(fault));
    let done = job();
    CHOSEN.set(before);
    done
}
