//! Long work without the lock of the interpreter: signals are looked at, and progress is told, while it goes on.

use crate::errors::raised;
use pyo3::prelude::*;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;
use torse::{Error, Event, Pass, Verifier};

/// Between two looks at signals and progress.
const PAUSE: Duration = Duration::from_millis(50);

/// Does `work` on a thread of its own, which may use others. The calling thread looks at signals (Ctrl-C) and tells
/// `progress`, if there is one, how far it is: `progress(what, done, total)`; where that raises or returns `False` the work
/// is ended, also in the middle of a claim.
pub fn interruptible<T: Send>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&Verifier<'_>) -> Result<T, Error> + Send,
) -> PyResult<T> {
    let (ended, correcting) = (Arc::new(AtomicBool::new(false)), AtomicBool::new(false));
    let (done, total) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let observe = |event: Event<'_>| {
        match event {
            Event::Begins { pass, claims } => {
                correcting.store(pass == Pass::Correcting, Ordering::Relaxed);
                done.store(0, Ordering::Relaxed);
                total.store(claims, Ordering::Relaxed);
            }
            Event::ClaimEnds { .. } => {
                done.fetch_add(1, Ordering::Relaxed);
            }
            _ => {}
        }
        match ended.load(Ordering::Relaxed) {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        }
    };
    let progress = progress.map(|progress| progress.clone().unbind());
    let look = || -> PyResult<()> {
        Python::attach(|py| {
            py.check_signals()?;
            let Some(progress) = &progress else {
                return Ok(());
            };
            let what = match correcting.load(Ordering::Relaxed) {
                true => "correcting",
                false => "deciding",
            };
            let far = (done.load(Ordering::Relaxed), total.load(Ordering::Relaxed));
            let told = progress.bind(py).call1((what, far.0, far.1))?;
            if told.is_none() || told.is_truthy()? {
                return Ok(());
            }
            Err(raised(py, &Error::Cancelled))
        })
    };
    let (result, stopped) = py.detach(|| {
        std::thread::scope(|scope| {
            let (sender, receiver) = channel();
            let (observe, stop) = (&observe, &ended);
            scope.spawn(move || {
                let verifier = Verifier::new().observed_by(observe).stopped_by(stop);
                // Whoever waits for it is below.
                let _ = sender.send(work(&verifier));
            });
            let mut stopped = None;
            loop {
                match receiver.recv_timeout(PAUSE) {
                    Ok(result) => return (Some(result), stopped),
                    Err(RecvTimeoutError::Disconnected) => return (None, stopped),
                    Err(RecvTimeoutError::Timeout) if stopped.is_some() => {}
                    Err(RecvTimeoutError::Timeout) => {
                        if let Err(error) = look() {
                            ended.store(true, Ordering::Relaxed);
                            stopped = Some(error);
                        }
                    }
                }
            }
        })
    });
    if let Some(error) = stopped {
        return Err(error);
    }
    match result {
        Some(Ok(value)) => {
            look()?;
            Ok(value)
        }
        Some(Err(error)) => Err(raised(py, &error)),
        None => Err(raised(py, &Error::Cancelled)),
    }
}
