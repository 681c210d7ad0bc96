// Runs the mesher so that Python stays responsive: on a thread of its own, without the GIL, with
// callbacks into Python whose errors reach the caller.
#pragma once

#include <af2/geometry/position_size.h>

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>

#include "python/bindings/common.h"

namespace af2::python {

/// One call from Python: how it is stopped, and what went wrong in callbacks.
class Call {
 public:
  std::stop_token token() const { return stop_.get_token(); }

  /// Calls back into Python, from any thread. The first error is kept for the caller and stops the
  /// run; after it, nothing is called any more. Throws InputError then.
  void back(const std::function<void()>& callback);

  /// Runs `work` on a thread of its own. Meanwhile Python handles signals: Ctrl-C stops the run.
  /// May be called again, for questions about the result. The GIL must be held. Throws what `work`
  /// throws, and errors of Python.
  void run(const std::function<void()>& work);

 private:
  void keep(std::exception_ptr error);

  std::stop_source stop_;
  std::mutex mutex_;
  std::exception_ptr error_;  // of Python
  std::atomic<bool> hasFailed_{false};
};

/// Sizes from a callable that takes an array of points, shape (n, 3), and returns n sizes or one
/// for all. `call` is kept alive.
geometry::PositionSize sizesFrom(py::object callable, std::shared_ptr<Call> call);

/// An object of Python that any thread may drop.
std::shared_ptr<py::object> shared(py::object object);

}  // namespace af2::python
