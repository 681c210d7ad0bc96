#include "geometry/mpi/messages/post.h"

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>
#include <utility>

namespace af2::mpi {
namespace {

constexpr int kHeadTag = 0, kRestTag = 1;
constexpr std::size_t kMostBesideHead = 1 << 15;
/// MPI counts with int.
constexpr std::size_t kLargestPart = std::size_t{1} << 30;

std::size_t partOf(std::size_t size, std::size_t at) { return std::min(kLargestPart, size - at); }

std::string machineName() {
  char name[MPI_MAX_PROCESSOR_NAME] = "";
  int length = 0;
  MPI_Get_processor_name(name, &length);
  return {name, static_cast<std::size_t>(length)};
}

}  // namespace

/// What goes before the bytes of a letter, and before longer letters alone.
struct Post::Head {
  Topic topic = 0;
  std::uint32_t isForAll = 0;
  std::uint64_t size = 0;
};

struct Post::Parcel {
  int to = 0;
  Head head;
  std::shared_ptr<const Bytes> bytes;
};

/// Parcels stay in memory until MPI has sent them.
struct Post::Outgoing {
  struct OnItsWay {
    Bytes head;
    std::shared_ptr<const Bytes> rest;
    std::vector<MPI_Request> requests;
  };
  MPI_Comm comm;
  std::deque<OnItsWay> all = {};

  void add(Parcel parcel) {
    OnItsWay& next = all.emplace_back();
    const Bytes& bytes = *parcel.bytes;
    const bool isShort = bytes.size() <= kMostBesideHead;
    next.head.resize(sizeof(Head) + (isShort ? bytes.size() : 0));
    std::memcpy(next.head.data(), &parcel.head, sizeof(Head));
    if (isShort) std::ranges::copy(bytes, next.head.begin() + sizeof(Head));
    send(next, next.head.data(), next.head.size(), parcel.to, kHeadTag);
    if (isShort) return;
    next.rest = std::move(parcel.bytes);
    for (std::size_t at = 0; at < bytes.size(); at += kLargestPart)
      send(next, bytes.data() + at, partOf(bytes.size(), at), parcel.to, kRestTag);
  }

  /// Frees those that were sent.
  void sweep() {
    std::erase_if(all, [](OnItsWay& one) {
      int isSent = 0;
      MPI_Testall(static_cast<int>(one.requests.size()), one.requests.data(), &isSent,
                  MPI_STATUSES_IGNORE);
      return isSent != 0;
    });
  }

 private:
  void send(OnItsWay& parcel, const std::byte* data, std::size_t size, int to, int tag) {
    MPI_Isend(data, static_cast<int>(size), MPI_BYTE, to, tag, comm,
              &parcel.requests.emplace_back());
  }
};

Post::Post(MPI_Comm processes) {
  int level = 0;
  MPI_Query_thread(&level);
  if (level < MPI_THREAD_SERIALIZED)
    throw InputError("start MPI by MPI_Init_thread with MPI_THREAD_SERIALIZED or more");
  MPI_Comm_dup(processes, &comm_);
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &ranks_);
  machine_ = machineName();
  thread_ = std::thread([this] { run(); });
}

Post::~Post() {
  {
    const std::lock_guard lock(mutex_);
    isClosing_ = true;
    toSend_.notify_one();
  }
  thread_.join();
  MPI_Comm_free(&comm_);
}

std::string Post::name() const { return "rank " + std::to_string(rank_) + " on " + machine_; }

void Post::handle(Topic topic, Handler handler) {
  const std::lock_guard lock(mutex_);
  handlers_[topic] = std::move(handler);
}

void Post::send(int to, Topic topic, Bytes bytes) {
  const std::size_t size = bytes.size();
  const std::lock_guard lock(mutex_);
  parcels_.push_back({to, {topic, 0, size}, std::make_shared<const Bytes>(std::move(bytes))});
  toSend_.notify_one();
}

void Post::sendToAll(Topic topic, Bytes bytes) { passOn({rank_, topic, std::move(bytes)}); }

Letter Post::receive(Topic topic) {
  std::unique_lock lock(mutex_);
  std::deque<Letter>& letters = inbox_[topic];
  arrived_.wait(lock, [&] { return !letters.empty(); });
  Letter letter = std::move(letters.front());
  letters.pop_front();
  return letter;
}

void Post::run() {
  try {
    exchangeLetters();
  } catch (const std::exception& fault) {  // without its messages, the run cannot go on
    std::fputs(("af2-mpi: error: " + name() + " lost a message: " + fault.what() + "\n").c_str(),
               stderr);
    MPI_Abort(comm_, 1);
  }
}

/// Until all processes have sent what they had to send: others may still want answers.
void Post::exchangeLetters() {
  using Clock = std::chrono::steady_clock;
  Outgoing outgoing{comm_};
  MPI_Request allAreReady = MPI_REQUEST_NULL;
  bool isReady = false;
  for (Clock::time_point last = Clock::now();;) {
    const bool hasSent = sendParcels(outgoing), hasTaken = takeLetter();
    const Clock::time_point now = Clock::now();
    if (hasSent || hasTaken) last = now;
    if (outgoing.all.empty() && isClosing()) {
      if (!std::exchange(isReady, true)) MPI_Ibarrier(comm_, &allAreReady);
      int areReady = 0;
      MPI_Test(&allAreReady, &areReady, MPI_STATUS_IGNORE);
      if (areReady != 0) return;
    }
    // MPI may send a long letter piece by piece, and each must be seen to.
    if (!outgoing.all.empty())
      std::this_thread::yield();
    else
      rest(std::chrono::duration_cast<std::chrono::microseconds>(now - last), isReady);
  }
}

bool Post::sendParcels(Outgoing& outgoing) {
  std::vector<Parcel> parcels;
  {
    const std::lock_guard lock(mutex_);
    parcels.swap(parcels_);
  }
  for (Parcel& parcel : parcels) outgoing.add(std::move(parcel));
  outgoing.sweep();
  return !parcels.empty();
}

/// Also those that do not exist, so that a single process need not look for any.
bool Post::takeLetter() {
  if (ranks_ == 1) return false;
  int isThere = 0, size = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, kHeadTag, comm_, &isThere, &status);
  if (isThere == 0) return false;
  MPI_Get_count(&status, MPI_BYTE, &size);
  Bytes first(static_cast<std::size_t>(size));
  MPI_Recv(first.data(), size, MPI_BYTE, status.MPI_SOURCE, kHeadTag, comm_, MPI_STATUS_IGNORE);
  Head head;
  std::memcpy(&head, first.data(), sizeof head);
  Letter letter{status.MPI_SOURCE, head.topic, {}};
  if (first.size() == sizeof head + head.size) {
    letter.bytes.assign(first.begin() + sizeof head, first.end());
  } else {
    letter.bytes.resize(head.size);
    for (std::size_t at = 0; at < head.size; at += kLargestPart)
      MPI_Recv(letter.bytes.data() + at, static_cast<int>(partOf(head.size, at)), MPI_BYTE,
               letter.from, kRestTag, comm_, MPI_STATUS_IGNORE);
  }
  take(std::move(letter), head.isForAll != 0);
  return true;
}

void Post::take(Letter letter, bool isForAll) {
  if (isForAll) passOn(letter);
  std::unique_lock lock(mutex_);
  if (const auto handler = handlers_.find(letter.topic); handler != handlers_.end()) {
    lock.unlock();  // handlers are set before letters for them can arrive
    return handler->second(letter);
  }
  inbox_[letter.topic].push_back(std::move(letter));
  arrived_.notify_all();
}

/// The processes are the nodes of a binary tree, so that the time to reach all of them grows with
/// the logarithm of their number.
void Post::passOn(const Letter& letter) {
  const auto bytes = std::make_shared<const Bytes>(letter.bytes);
  const std::lock_guard lock(mutex_);
  for (const int child : {2 * rank_ + 1, 2 * rank_ + 2})
    if (child < ranks_) parcels_.push_back({child, {letter.topic, 1, bytes->size()}, bytes});
  toSend_.notify_one();
}

/// Looking for letters takes processor time, which the threads that mesh need. So a letter may wait
/// for a part of the time in which none came.
void Post::rest(std::chrono::microseconds idle, bool isWaiting) {
  constexpr int kPart = 8;
  constexpr std::chrono::microseconds kShortest(5), kLongest(1000);
  if (idle < kPart * kShortest) return std::this_thread::yield();
  std::unique_lock lock(mutex_);
  const auto isNeeded = [&] { return !parcels_.empty() || (isClosing_ && !isWaiting); };
  if (ranks_ == 1 && !isWaiting) return toSend_.wait(lock, isNeeded);
  toSend_.wait_for(lock, std::min(idle / kPart, kLongest), isNeeded);
}

bool Post::isClosing() {
  const std::lock_guard lock(mutex_);
  return isClosing_ && parcels_.empty();
}

}  // namespace af2::mpi
