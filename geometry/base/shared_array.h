// Arrays that copies share. Not installed.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

namespace af2::geometry {

/// A vector that takes memory once for all its copies, until one of them is changed. After it has
/// been moved from, it may only be destroyed or assigned to.
template <class T>
class SharedArray {
 public:
  operator const std::vector<T>&() const { return *data_; }
  std::size_t size() const { return data_->size(); }
  const T& operator[](std::size_t i) const { return (*data_)[i]; }
  const T& front() const { return data_->front(); }
  const T& back() const { return data_->back(); }
  auto begin() const { return data_->cbegin(); }
  auto end() const { return data_->cend(); }
  bool operator==(const SharedArray& other) const {
    return data_ == other.data_ || *data_ == *other.data_;
  }

  /// To be changed; what the copies have stays as it is. A reference from before may be to theirs.
  std::vector<T>& edit() {
    if (data_.use_count() > 1) data_ = std::make_shared<std::vector<T>>(*data_);
    // What another thread read from a copy that it has just given up comes before what is written.
    std::atomic_thread_fence(std::memory_order_acquire);
    return *data_;
  }

 private:
  std::shared_ptr<std::vector<T>> data_ = std::make_shared<std::vector<T>>();
};

}  // namespace af2::geometry
