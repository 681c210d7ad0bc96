#include "python/bindings/run.h"

#include <af2/engine/error.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <string>
#include <thread>

namespace af2::python {

std::shared_ptr<py::object> shared(py::object object) {
  return {new py::object(std::move(object)), [](py::object* owned) {
            const py::gil_scoped_acquire gil;
            delete owned;
          }};
}

void Call::keep(std::exception_ptr error) {
  const std::lock_guard lock(mutex_);
  if (!error_) error_ = std::move(error);
  hasFailed_ = true;
  stop_.request_stop();
}

void Call::back(const std::function<void()>& callback) {
  if (!hasFailed_) {
    const py::gil_scoped_acquire gil;
    try {
      return callback();
    } catch (const py::error_already_set&) {
      keep(std::current_exception());
    }
  }
  throw InputError("a callback raised an exception");
}

void Call::run(const std::function<void()>& work) {
  std::mutex mutex;
  std::condition_variable ended;
  bool hasEnded = false;
  std::exception_ptr failure;
  {
    const py::gil_scoped_release noGil;
    std::thread worker([&] {
      try {
        work();
      } catch (...) {
        failure = std::current_exception();
      }
      const std::lock_guard lock(mutex);
      hasEnded = true;
      ended.notify_one();
    });
    std::unique_lock lock(mutex);
    constexpr std::chrono::milliseconds kBetweenSignals(50);
    while (!ended.wait_for(lock, kBetweenSignals, [&] { return hasEnded; })) {
      lock.unlock();
      {
        const py::gil_scoped_acquire gil;
        if (PyErr_CheckSignals() != 0) keep(std::make_exception_ptr(py::error_already_set()));
      }
      lock.lock();
    }
    lock.unlock();
    worker.join();
  }
  if (error_) {
    std::exception_ptr error = std::move(error_);
    error_ = nullptr;
    hasFailed_ = false;
    std::rethrow_exception(error);
  }
  if (failure) std::rethrow_exception(failure);
}

namespace {

/// Python may keep the array, so it gets a copy of the points.
py::array copyOf(std::span<const Point3> points) {
  py::array_t<double> array(std::vector<py::ssize_t>{static_cast<py::ssize_t>(points.size()), 3});
  std::copy(points.begin(), points.end(), reinterpret_cast<Point3*>(array.mutable_data()));
  return array;
}

void fill(const py::object& callable, std::span<const Point3> at, std::span<double> sizes) {
  const py::object result = callable(copyOf(at));
  const auto values = PointArray::ensure(result);
  if (!values) {
    PyErr_Clear();
    throw py::type_error("sizes(points) must return numbers, one for each point or one for all");
  }
  if (values.size() == 1 && values.ndim() == 0) {
    std::ranges::fill(sizes, *values.data());
    return;
  }
  if (values.ndim() != 1 || values.size() != static_cast<py::ssize_t>(at.size()))
    throw py::value_error("sizes(points) must return one number for each of the " +
                          std::to_string(at.size()) + " points, an array of the shape (" +
                          std::to_string(at.size()) + ",)");
  std::copy_n(values.data(), at.size(), sizes.begin());
}

/// As errors of Python, which Call keeps.
void fillOrFail(const py::object& callable, std::span<const Point3> at, std::span<double> sizes) {
  try {
    fill(callable, at, sizes);
  } catch (const py::builtin_exception& error) {
    error.set_error();
    throw py::error_already_set();
  }
}

}  // namespace

geometry::PositionSize sizesFrom(py::object callable, std::shared_ptr<Call> call) {
  return geometry::PositionSize([function = shared(std::move(callable)), call = std::move(call)](
                                    std::span<const Point3> at, std::span<double> sizes) {
    call->back([&] { fillOrFail(*function, at, sizes); });
  });
}

}  // namespace af2::python
