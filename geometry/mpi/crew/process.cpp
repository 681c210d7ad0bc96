#include "geometry/mpi/crew/process.h"

#include <algorithm>
#include <exception>

#include "geometry/mpi/crew/follower.h"
#include "geometry/mpi/crew/leader.h"
#include "geometry/mpi/crew/topics.h"

namespace af2::mpi {

Process::Process(MPI_Comm processes, int threads) : post_(processes) {
  const auto count = static_cast<std::size_t>(std::max(1, threads));
  if (post_.isFirst())
    leader_ = std::make_unique<Leader>(post_, count);
  else
    follower_ = std::make_unique<Follower>(post_, count);
}

/// Others would wait for a leader that has thrown.
Process::~Process() {
  if (leader_ && std::uncaught_exceptions() > 0) leader_->stop("rank 0 could not go on", 1);
}

/// Alone, threads do better without a board of tasks.
geometry::CrewLeader* Process::leader() { return post_.ranks() > 1 ? leader_.get() : nullptr; }
geometry::CrewFollower* Process::follower() { return follower_.get(); }

void Process::order(int process, Order order, Bytes bytes) {
  post_.send(process, kOrders, bytesOf(order, bytes));
}

void Process::orderAll(Order order, Bytes bytes) {
  if (post_.ranks() > 1) post_.sendToAll(kOrders, bytesOf(order, bytes));
}

void Process::waitForDone(int processes) { leader_->waitForDone(processes); }

Bytes Process::waitFor(Order order) { return follower_->waitFor(order); }

void Process::done() { post_.send(0, kDone, {}); }

void Process::stop(const std::string& reason, int code) { leader_->stop(reason, code); }

void Process::giveUp(const std::string& reason) {
  post_.send(0, kGivenUp, bytesOf(post_.name() + ": " + reason));
}

int Process::waitForStop() { return follower_->waitForStop(); }

}  // namespace af2::mpi
