// Messages between the processes of a run. One thread of each process does all that MPI does.
#pragma once

#include <mpi.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "geometry/mpi/messages/bytes.h"

namespace af2::mpi {

/// What a message is about; the numbers are up to the users of a post.
using Topic = std::uint32_t;

struct Letter {
  int from = 0;
  Topic topic = 0;
  Bytes bytes;
};

/// The messages of one process. Letters that a process sends to another arrive in the order in
/// which it sent them. They may be of any length: counts are 64 bits wide.
class Post {
 public:
  /// Called on the thread of the post; must not wait for letters.
  using Handler = std::function<void(const Letter&)>;

  /// All processes of the communicator make a post at the same time, and give it up at the same
  /// time. While there is one, MPI must not be called for anything else.
  ///
  /// Throws InputError if MPI does not let threads other than the first call it.
  explicit Post(MPI_Comm processes);
  /// Sends what is still to be sent.
  ~Post();
  Post(const Post&) = delete;
  Post& operator=(const Post&) = delete;

  int rank() const { return rank_; }
  int ranks() const { return ranks_; }
  bool isFirst() const { return rank_ == 0; }
  /// For messages to people: "rank 3 on node17".
  std::string name() const;

  /// Letters about this topic go to the handler.
  void handle(Topic topic, Handler handler);
  /// May be called from any thread, also by handlers, but not for a letter to oneself.
  void send(int to, Topic topic, Bytes bytes);
  /// Sends to all other processes, which pass it on to each other. Only the first may call it.
  void sendToAll(Topic topic, Bytes bytes);
  /// Waits for the next letter about a topic that has no handler.
  Letter receive(Topic topic);

 private:
  struct Head;      // what goes before a letter
  struct Parcel;    // a letter on its way out
  struct Outgoing;  // those that MPI sends
  void run();
  void exchangeLetters();
  bool sendParcels(Outgoing& outgoing);
  bool takeLetter();
  void take(Letter letter, bool isForAll);
  void passOn(const Letter& letter);
  void rest(std::chrono::microseconds idle, bool isWaiting);
  bool isClosing();

  MPI_Comm comm_ = MPI_COMM_NULL;
  int rank_ = 0, ranks_ = 1;
  std::string machine_;
  std::mutex mutex_;
  std::condition_variable arrived_, toSend_;
  std::map<Topic, Handler> handlers_;
  std::map<Topic, std::deque<Letter>> inbox_;
  std::vector<Parcel> parcels_;
  bool isClosing_ = false;
  std::thread thread_;
};

}  // namespace af2::mpi
