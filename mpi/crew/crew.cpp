#include "mpi/crew/crew.h"

#include <algorithm>
#include <exception>

#include "mpi/crew/follower.h"
#include "mpi/crew/leader.h"
#include "mpi/crew/topics.h"

namespace af2::mpi {

Crew::Crew(MPI_Comm processes, int threads) : post_(processes) {
  const auto count = static_cast<std::size_t>(std::max(1, threads));
  if (post_.isFirst())
    leader_ = std::make_unique<Leader>(post_, count);
  else
    follower_ = std::make_unique<Follower>(post_, count);
}

/// Others would wait for a leader that has thrown.
Crew::~Crew() {
  if (leader_ && std::uncaught_exceptions() > 0) leader_->stop("rank 0 could not go on", 1);
}

/// Alone, threads do better without a board of tasks.
geometry::CrewLeader* Crew::leader() { return post_.ranks() > 1 ? leader_.get() : nullptr; }
geometry::CrewFollower* Crew::follower() { return follower_.get(); }

void Crew::order(int process, Order order, Bytes bytes) {
  post_.send(process, kOrders, bytesOf(order, bytes));
}

void Crew::orderAll(Order order, Bytes bytes) {
  if (post_.ranks() > 1) post_.sendToAll(kOrders, bytesOf(order, bytes));
}

void Crew::waitForDone(int processes) { leader_->waitForDone(processes); }

Bytes Crew::waitFor(Order order) { return follower_->waitFor(order); }

void Crew::done() { post_.send(0, kDone, {}); }

void Crew::stop(const std::string& reason, int code) { leader_->stop(reason, code); }

void Crew::giveUp(const std::string& reason) {
  post_.send(0, kGivenUp, bytesOf(post_.name() + ": " + reason));
}

int Crew::waitForStop() { return follower_->waitForStop(); }

}  // namespace af2::mpi
