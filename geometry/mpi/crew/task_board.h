// The tries of a round that nobody has begun, the largest first, and the pieces of cut faces.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/mpi/crew/tasks.h"

namespace af2::mpi {

/// Kept by the leader of a crew; may be used by several threads.
class TaskBoard {
 public:
  /// takers  how many threads of all processes take tasks
  explicit TaskBoard(std::size_t takers) : takers_(takers) {}

  /// work  by try. Returns the number of the round, which is never 0.
  std::uint64_t begin(std::span<const geometry::FaceTry> tries, std::span<const double> work);
  /// One large try, or several small ones; if all are taken, the pieces of a face. None: there is
  /// nothing to do now, but there may be later.
  std::optional<Task> takeIfAny(std::uint64_t round);
  /// Waits until there is something to do, or the round is over.
  Task take(std::uint64_t round);
  void finish(std::size_t tries);

  void offer(const RegionKey& region, int owner, std::span<const double> work);
  std::optional<std::size_t> nextPiece(const RegionKey& region, bool isInvited);

  /// Somebody has done something else than a task.
  void done();
  /// Waits until that many more are done. Throws InputError if somebody has given up.
  void waitForDone(int count);

  /// No more tasks are taken: all rounds are over.
  void giveUp(const std::string& reason);
  /// Throws InputError if somebody has given up.
  void check();

 private:
  struct Region {
    RegionKey key;
    int owner = 0;
    std::vector<std::size_t> order;
    std::size_t next = 0;
    std::size_t invited = 0;  ///< threads that will come for a piece
  };
  void change();
  Task nextTries();
  std::optional<Task> nextHelp();

  std::size_t takers_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t changes_ = 0;
  std::uint64_t round_ = 0;
  std::vector<geometry::FaceTry> tries_;
  std::vector<double> work_;
  std::vector<std::size_t> order_;
  std::size_t next_ = 0, unfinished_ = 0;
  double workLeft_ = 0;
  std::map<std::uint64_t, Region> regions_;  ///< by number of the try
  int done_ = 0;
  std::string givenUp_;
};

}  // namespace af2::mpi
