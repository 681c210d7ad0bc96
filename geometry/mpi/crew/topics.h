// What the letters of a crew are about.
#pragma once

#include "geometry/mpi/messages/post.h"

namespace af2::mpi {

enum CrewTopic : Topic {
  kOrders = 1,  ///< from the leader to all: an Order, and what belongs to it
  kAsk,         ///< to the leader: a thread, by its slot, wants a task of a round
  kAskPiece,    ///< to the leader: a thread, by its slot, wants a piece of a region
  kOffer,       ///< to the leader: a region, and the work of its pieces
  kResults,     ///< to the leader: the number of a round, and meshes with their numbers
  kPiece,       ///< to the owner of a region: a piece, with its mesh
  kDone,        ///< to the leader: a process has done what it was told
  kGivenUp,     ///< to the leader: why a process cannot go on
  kFetch,       ///< to who keeps a face: its number, and where to send its bytes
  kForget,      ///< to who keeps a face: its number; it is not needed any more
  kAbandon,     ///< from the leader to all: what others still owe will not come
  kReplies,     ///< and those after it, by slot: answers of the leader
};

/// Answers to kFetch, by what the process that asks has called it.
inline Topic fetchedBy(std::uint64_t call) { return (1u << 30) + static_cast<Topic>(call); }

inline Topic replyTo(std::uint64_t slot) { return kReplies + static_cast<Topic>(slot); }

enum class Order {
  TakeModel,
  BeginRun,
  BeginRound,
  EndRun,
  EndModel,
  BeginParts,
  TakePart,
  Commit,
  Stop
};

}  // namespace af2::mpi
