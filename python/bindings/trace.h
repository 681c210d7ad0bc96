// Tells a callable of Python about every step of a run.
#pragma once

#include <af2/engine/observer.h>

#include <functional>
#include <memory>

#include "python/bindings/run.h"

namespace af2::python {

/// Observers for MeshingOptions::observer. Every step is a call of Python, so it is slow.
std::function<AF2MeshingObserver*(int face)> tracersFor(py::object callable,
                                                        std::shared_ptr<Call> call);

void bindTrace(py::module_& module);

}  // namespace af2::python
