// Traces: the decisions of a run in a small file, and the command line that makes the run again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "engine/step/observer.h"

namespace af2::cli {

/// One entry, 16 bytes.
struct TraceEntry {
  enum class Kind : std::uint8_t {
    Refused,  ///< no rule was applied at the base edge `from` -> `to`
    Applied,
    Begin,  ///< of a front: a region, one of its pieces, or another attempt; `from`: its vertices
    End,    ///< of a front; `from`: edges that are left
    // What an advance did beside steps; see FrontAct.
    Weld,     ///< vertex `from` has become `to`; comes before its step
    Row,      ///< a row was complete; `from`: the vertices that were moved
    Columns,  ///< `from`: the vertices that got counts of their own
    Path,     ///< a path of new edges from vertex `from` to `to`; comes before its step
  };
  std::uint32_t from = 0, to = 0;
  float score = 0;         ///< Applied only
  std::uint16_t rule = 0;  ///< Applied only: index in the rule set
  std::uint8_t level = 0;  ///< of a step, at most 255
  Kind kind = Kind::Refused;
  bool isStep() const { return kind == Kind::Refused || kind == Kind::Applied; }
  bool operator==(const TraceEntry&) const = default;
};

/// The entries of one face, in the order of time. Steps are counted from 1 over all fronts.
using FaceTrace = std::vector<TraceEntry>;

struct Trace {
  std::vector<std::string> arguments;  ///< of `af2 mesh`, without those that name outputs
  std::filesystem::path directory;     ///< in which the run was started
  std::vector<std::string> ruleNames;
  /// By file that the run has read: a checksum of its content.
  std::map<std::string, std::uint64_t> checksums;
  std::map<int, FaceTrace> faces;  ///< by id
};

/// Throws InputError if a file cannot be read.
std::uint64_t checksumOf(const std::filesystem::path& file);

void writeTrace(const Trace& trace, const std::filesystem::path& file);
/// Throws InputError if the file is no trace, is damaged, or was written by another version of AF2.
Trace readTrace(const std::filesystem::path& file);

/// Collects the entries of a run, whose faces may be meshed by several threads.
class TraceRecorder {
 public:
  /// faces  ids of the faces that are recorded; empty: all
  explicit TraceRecorder(std::vector<int> faces) : faces_(std::move(faces)) {}

  /// The same, before the run.
  void restrictTo(std::vector<int> faces) { faces_ = std::move(faces); }

  /// The observer of a face, or null if the face is not recorded. Valid as long as the recorder.
  AF2MeshingObserver* observerOf(int face);
  /// What was recorded; the recorder is empty then.
  std::map<int, FaceTrace> take();

 private:
  class FaceRecorder final : public AF2MeshingObserver {
   public:
    void frontBegun(const FrontInput& input) override;
    void stepTaken(const StepReport& step) override;
    void frontActed(const FrontAct& act, const Mesh&) override;
    void frontEnded(std::size_t edgesLeft) override;
    FaceTrace entries;
  };

  std::vector<int> faces_;
  std::mutex mutex_;
  std::map<int, FaceRecorder> recorders_;
};

}  // namespace af2::cli
