//! Deliberate faults, made in tests to show that each is caught.
//!
//! A tool that says "proved" has to show what happens when it errs. Each [`InjectedFault`] names one deliberate
//! mistake of an engine like this one; the code that could make the mistake asks [`injected`]. Faults exist only in
//! builds with debug assertions, and only [`with`], which nothing but tests calls, makes one. In a release build
//! [`injected`] is the constant `false`, so the compiler removes them.

/// A deliberate mistake.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InjectedFault {
    /// The declared range of an eliminated symbol is forgotten: no constraint takes its place.
    RangeForgotten,
    /// The conditions of a proof are dropped.
    ConditionDropped,
    /// An assumption is used with the wrong sign.
    AssumptionReversed,
    /// An assumption about one symbol bounds it on the wrong side.
    BoundReversed,
    /// A multiple of an assumption enters a certificate of sign with the wrong sign.
    CertificateSign,
    /// A nonnegative number is taken for a positive one.
    ZeroTakenForPositive,
    /// The index of a sum of symbolic length stays free in the argument of a basis.
    IndexLeftFree,
    /// A basis of lower degree than its seeds is taken for the seeds.
    DegreeBelowSeeds,
    /// An empty sum has a term.
    EmptySumHasTerm,
    /// A point is substituted before the derivative is taken.
    ValueBeforeDerivative,
    /// The derivative of a power of the step lacks the exponent as a factor.
    PowerWithoutFactor,
    /// The derivative of the cosine has the wrong sign.
    CosineRate,
    /// The cosine of a sum of angles has the wrong sign.
    AngleSum,
    /// A determinant is computed as a permanent (without the signs).
    DeterminantWithoutSigns,
    /// Only the first half of a conjunction is decided.
    SecondHalfIgnored,
    /// A domain whose closed end belongs to it is called empty.
    ClosedEndExcluded,
    /// A counterexample need not satisfy the assumptions.
    WitnessAnywhere,
    /// A decimal counts as agreeing although it is off by one unit in its last place.
    RoundingTooWide,
    /// A candidate for a correction is accepted without a proof.
    CorrectionUnproved,
    /// A coefficient of a determinant is taken for positive on a cell without a test.
    CoefficientUnlooked,
    /// The root of a square is taken for the base, whatever the sign of the base.
    RootSignIgnored,
    /// An integral is the antiderivative at the upper end alone.
    LowerEndForgotten,
    /// A product that telescopes ends one factor early.
    LastFactorForgotten,
    /// The checker of proofs reads a difference as a sum.
    DifferenceReadAsSum,
    /// Of nested derivatives of a smooth function the highest order is used instead of the sum of the orders.
    OrdersByMaximum,
    /// A property of a basis does not see the values substituted by `at`.
    PropertyOutsideScope,
    /// The body of a definition does not see the values substituted by `at`.
    DefinitionOutsideScope,
    /// The index of a sum is visible in the body of a definition.
    IndexCaptured,
    /// `at` does not move an argument of a basis that is left out in the text.
    LeftOutNotMoved,
    /// The seeds of a basis are not searched for the variable of a derivative under a root.
    SeedOverlooked,
    /// The negation of `p and q` is `not p and not q`.
    DenialOfBoth,
    /// The second link of a chain compares with the first side.
    ChainFromFirst,
    /// `F''` is differentiated once.
    PrimesOnce,
    /// An integral goes from its upper to its lower end.
    EndsExchanged,
    /// A function is differentiated by its first parameter, whichever parameter is named.
    FirstParameter,
    /// A witness may lie on an open end of its set.
    OpenEndIncluded,
    /// The parser groups differences from the right.
    DifferenceFromTheRight,
    /// A sign binds more tightly than a power.
    SignBeforePower,
    /// The printed digits of a number are not counted.
    DecimalsForgotten,
    /// An outer declaration hides an inner one of the same name.
    OuterDeclarationKept,
    /// The last hypothesis of a claim is not read.
    HypothesisLeftOut,
    /// An open end of an interval is taken for a closed one.
    OpenEndClosed,
    /// A root or a logarithm with a witness in it is taken to have a value.
    WitnessValueAssumed,
    /// The upper end of a root is rounded down.
    RoundedInward,
    /// The upper end of an arc tangent or an arc sine is rounded down.
    ArcRoundedDown,
    /// The Taylor coefficients of an arc lack the products with earlier ones.
    ArcWithoutEarlier,
    /// An angle with the right tangent or sine is taken for the arc, wherever it lies.
    ArcOfAnyBranch,
    /// Arcs are ordered the other way round.
    ArcsReversed,
    /// The upper end of a logarithm is rounded down.
    LogarithmRoundedDown,
    /// The Taylor coefficients of a logarithm lack the products with earlier ones.
    LogarithmWithoutEarlier,
    /// The logarithm of a product lacks the logarithm of its last factor.
    LogarithmFactorForgotten,
    /// Of two exponentials the one with the smaller exponent is taken for the larger.
    ExponentsReversed,
    /// The term of a sum does not see the index of the sum.
    IndexNotSeen,
    /// The values substituted by `at` are ignored.
    MovedNotSeen,
    /// A derivative of higher order is computed as the first derivative.
    OrderForgotten,
    /// The factors of the step of a basis change places.
    StepFactorsExchanged,
    /// Premise and conclusion change places.
    ImplicationReversed,
    /// The hyperbolic cosine is half a difference of exponentials instead of half a sum.
    CoshAsDifference,
    /// The absolute value of a number is the number itself.
    SizeAsItself,
    /// What is proved where a number is not negative is proved.
    OtherSideForgotten,
    /// The greater one of two numbers is the smaller one.
    GreaterAsSmaller,
    /// The arguments of a function come in the opposite order.
    ArgumentsExchanged,
    /// A product is read as a sum.
    ProductAsSum,
    /// A printed decimal loses its sign.
    PrintedSignLost,
    /// The points at which a divisor of an elimination vanishes are forgotten.
    CaseForgotten,
    /// The evaluator of trees returns a remembered value although substituted values have changed since.
    StaleMemory,
    /// The stream of random points always makes the same choice.
    StreamDegenerate,
}

#[cfg(debug_assertions)]
thread_local! {
    static CHOSEN: std::cell::Cell<Option<InjectedFault>> = const { std::cell::Cell::new(None) };
}

/// Whether this thread is to make the mistake.
#[cfg(debug_assertions)]
#[must_use]
pub fn injected(fault: InjectedFault) -> bool {
    CHOSEN.get() == Some(fault)
}

/// Whether to make the mistake: never in a release build.
#[cfg(not(debug_assertions))]
#[inline(always)]
#[must_use]
pub const fn injected(_: InjectedFault) -> bool {
    false
}

/// Runs `job` on this thread with this one fault injected, and restores the former state afterwards.
#[cfg(debug_assertions)]
pub fn with<T>(fault: InjectedFault, job: impl FnOnce() -> T) -> T {
    let before = CHOSEN.replace(Some(fault));
    let result = job();
    CHOSEN.set(before);
    result
}
