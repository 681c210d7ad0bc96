// Values as bytes and back, bit for bit, for processes of one program on machines of one kind.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/base/error.h"

namespace af2::mpi {

using Bytes = std::vector<std::byte>;

/// A type or the same type, const. The functions `pass` of a type take both, because one function
/// writes and reads.
template <class T, class Wanted>
concept Is = std::is_same_v<std::remove_const_t<T>, Wanted>;

/// Types whose bytes are their value. Do not pass any that hold pointers.
template <class T>
concept Plain = std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>;

/// Appends values to bytes. Types that are not plain, nor made of such by the standard library,
/// need a function `pass(archive, value)`, which names their parts.
class ByteWriter {
 public:
  template <class... T>
  void operator()(const T&... values) {
    (put(values), ...);
  }
  /// Without their number, for what comes last.
  void append(const void* data, std::size_t size) {
    if (size == 0) return;
    const std::size_t at = bytes_.size();
    bytes_.resize(at + size);
    std::memcpy(bytes_.data() + at, data, size);
  }
  Bytes take() { return std::move(bytes_); }
  std::size_t size() const { return bytes_.size(); }

 private:
  template <class T>
  void put(const T& value) {
    if constexpr (Plain<T>)
      append(&value, sizeof value);
    else
      pass(*this, value);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(std::uint64_t{values.size()});
    if constexpr (Plain<T>)
      append(values.data(), values.size() * sizeof(T));
    else
      for (const T& value : values) put(value);
  }
  void put(const std::vector<bool>& flags) {
    put(std::vector<std::uint8_t>(flags.begin(), flags.end()));
  }
  void put(const std::string& text) {
    put(std::uint64_t{text.size()});
    append(text.data(), text.size());
  }
  template <class A, class B>
  void put(const std::pair<A, B>& both) {
    (*this)(both.first, both.second);
  }
  template <class A, class B>
  void put(const std::map<A, B>& entries) {
    put(std::uint64_t{entries.size()});
    for (const auto& entry : entries) put(entry);
  }
  template <class T>
  void put(const std::optional<T>& value) {
    put(value.has_value());
    if (value) put(*value);
  }

  Bytes bytes_;
};

/// Takes values from bytes, in the order in which they were written. Throws InternalError if there
/// are fewer bytes.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <class... T>
  void operator()(T&... values) {
    (get(values), ...);
  }
  template <class T>
  T take() {
    T value{};
    get(value);
    return value;
  }
  std::span<const std::byte> rest() const { return bytes_; }

 private:
  void copy(void* data, std::size_t size) {
    if (size > bytes_.size()) throw InternalError("a message is shorter than what it should hold");
    if (size > 0) std::memcpy(data, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
  }
  std::size_t count() { return take<std::uint64_t>(); }

  template <class T>
  void get(T& value) {
    if constexpr (Plain<T>)
      copy(&value, sizeof value);
    else
      pass(*this, value);
  }
  template <class T>
  void get(std::vector<T>& values) {
    const std::size_t size = count();
    if (size > bytes_.size()) throw InternalError("a message is shorter than what it should hold");
    values.resize(size);
    if constexpr (Plain<T>)
      copy(values.data(), size * sizeof(T));
    else
      for (T& value : values) get(value);
  }
  void get(std::vector<bool>& flags) {
    std::vector<std::uint8_t> values;
    get(values);
    flags.assign(values.begin(), values.end());
  }
  void get(std::string& text) {
    text.resize(count());
    copy(text.data(), text.size());
  }
  template <class A, class B>
  void get(std::pair<A, B>& both) {
    (*this)(both.first, both.second);
  }
  template <class A, class B>
  void get(std::map<A, B>& entries) {
    entries.clear();
    for (std::size_t left = count(); left > 0; --left) {
      std::pair<A, B> entry;
      get(entry);
      entries.insert(std::move(entry));
    }
  }
  template <class T>
  void get(std::optional<T>& value) {
    value.reset();
    if (take<bool>()) get(value.emplace());
  }

  std::span<const std::byte> bytes_;
};

template <class... T>
Bytes bytesOf(const T&... values) {
  ByteWriter writer;
  writer(values...);
  return writer.take();
}

}  // namespace af2::mpi
