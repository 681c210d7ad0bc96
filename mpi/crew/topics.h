// What the letters of a crew are about.
#pragma once

#include "mpi/messages/post.h"

namespace af2::mpi {

enum CrewTopic : Topic {
  kOrders = 1,  ///< from the leader to all: an Order, and what belongs to it
  kTake,        ///< the number of a round: a thread wants tasks
  kTasks,       ///< the answer: tries with their numbers; none: there are no more
  kResults,     ///< meshes of faces, with the numbers of their tries
  kGivenUp,     ///< why a process cannot go on
  kDone,        ///< a process has done what it was told
};

enum class Order { TakeModel, BeginRun, BeginRound, EndRun, EndModel, TakePart, Commit, Stop };

}  // namespace af2::mpi
