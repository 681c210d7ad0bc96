#include "cli/meshing/trace_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/base/error.h"
#include "geometry/io/output_file.h"

namespace af2::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kMagic = "af2-trace 1\n";
static_assert(sizeof(TraceEntry) == 16);

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  throw InputError(
      fmt::format("'{}' {}; make it again with 'af2 mesh ... --trace FILE'", file.string(), why));
}

Json headOf(const Trace& trace) {
  Json head{{"version", AF2_VERSION},
            {"arguments", trace.arguments},
            {"directory", trace.directory.string()},
            {"rules", trace.ruleNames},
            {"checksums", trace.checksums},
            {"faces", Json::array()}};
  for (const auto& [id, entries] : trace.faces)
    head["faces"].push_back({{"id", id}, {"entries", entries.size()}});
  return head;
}

std::string readAll(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(fmt::format("cannot read '{}'", file.string()));
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Throws Json::exception if something is missing.
Trace traceFrom(const Json& head, std::string_view entries) {
  Trace trace;
  trace.arguments = head.at("arguments").get<std::vector<std::string>>();
  trace.directory = head.at("directory").get<std::string>();
  trace.ruleNames = head.at("rules").get<std::vector<std::string>>();
  trace.checksums = head.at("checksums").get<std::map<std::string, std::uint64_t>>();
  for (const Json& face : head.at("faces")) {
    FaceTrace& into = trace.faces[face.at("id").get<int>()];
    const auto bytes = face.at("entries").get<std::size_t>() * sizeof(TraceEntry);
    if (bytes > entries.size()) throw std::out_of_range("entries");
    into.resize(bytes / sizeof(TraceEntry));
    std::memcpy(static_cast<void*>(into.data()), entries.data(), bytes);
    entries.remove_prefix(bytes);
    const bool isSound = std::ranges::all_of(into, [&](const TraceEntry& entry) {
      return entry.kind <= TraceEntry::Kind::Path &&
             (entry.kind != TraceEntry::Kind::Applied || entry.rule < trace.ruleNames.size());
    });
    if (!isSound) throw std::out_of_range("entries");
  }
  if (!entries.empty()) throw std::out_of_range("entries");
  return trace;
}

}  // namespace

/// FNV-1a, 64 bits.
std::uint64_t checksumOf(const std::filesystem::path& file) {
  std::uint64_t sum = 14695981039346656037u;
  for (const char c : readAll(file)) sum = (sum ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return sum;
}

void writeTrace(const Trace& trace, const std::filesystem::path& file) {
  geometry::OutputFile output(file);
  output.text(kMagic);
  output.text(headOf(trace).dump(-1, ' ', false, Json::error_handler_t::replace));
  output.text("\n");
  for (const auto& [id, entries] : trace.faces)
    output.bytes(entries.data(), entries.size() * sizeof(TraceEntry));
  output.commit();
}

Trace readTrace(const std::filesystem::path& file) {
  const std::string text = readAll(file);
  if (!text.starts_with(kMagic)) refuse(file, "is not a trace of this version of AF2");
  const std::size_t end = text.find('\n', kMagic.size());
  if (end == std::string::npos) refuse(file, "is truncated");
  try {
    const Json head =
        Json::parse(text.begin() + kMagic.size(), text.begin() + static_cast<std::ptrdiff_t>(end));
    if (const auto version = head.at("version").get<std::string>(); version != AF2_VERSION)
      refuse(file,
             fmt::format("was written by version {} of AF2, and this is {}", version, AF2_VERSION));
    return traceFrom(head, std::string_view(text).substr(end + 1));
  } catch (const Json::exception&) {
    refuse(file, "is damaged");
  } catch (const std::out_of_range&) {
    refuse(file, "is damaged");
  }
}

void TraceRecorder::FaceRecorder::frontBegun(const FrontInput& input) {
  TraceEntry entry;
  entry.kind = TraceEntry::Kind::Begin;
  entry.from = static_cast<std::uint32_t>(input.vertexCount);
  entries.push_back(entry);
}

void TraceRecorder::FaceRecorder::stepTaken(const StepReport& step) {
  TraceEntry entry;
  entry.from = static_cast<std::uint32_t>(step.from.value);
  entry.to = static_cast<std::uint32_t>(step.to.value);
  entry.level = static_cast<std::uint8_t>(std::min(step.level, 255));
  if (step.applied) {
    entry.kind = TraceEntry::Kind::Applied;
    entry.rule = static_cast<std::uint16_t>(step.rule);
    entry.score = static_cast<float>(step.score);
  }
  entries.push_back(entry);
}

void TraceRecorder::FaceRecorder::frontActed(const FrontAct& act, const Mesh&) {
  const auto number = [](VertexId v) { return static_cast<std::uint32_t>(v.value); };
  TraceEntry entry;
  switch (act.kind) {
    case FrontAct::Kind::Weld:
    case FrontAct::Kind::Path:
      entry.kind =
          act.kind == FrontAct::Kind::Weld ? TraceEntry::Kind::Weld : TraceEntry::Kind::Path;
      entry.from = number(act.vertex);
      entry.to = number(act.other);
      break;
    case FrontAct::Kind::Row:
    case FrontAct::Kind::Columns:
      entry.kind =
          act.kind == FrontAct::Kind::Row ? TraceEntry::Kind::Row : TraceEntry::Kind::Columns;
      entry.from = static_cast<std::uint32_t>(act.count);
      break;
  }
  entries.push_back(entry);
}

void TraceRecorder::FaceRecorder::frontEnded(std::size_t edgesLeft) {
  TraceEntry entry;
  entry.kind = TraceEntry::Kind::End;
  entry.from = static_cast<std::uint32_t>(edgesLeft);
  entries.push_back(entry);
}

AF2MeshingObserver* TraceRecorder::observerOf(int face) {
  if (!faces_.empty() && std::ranges::count(faces_, face) == 0) return nullptr;
  const std::lock_guard lock(mutex_);
  return &recorders_[face];
}

std::map<int, FaceTrace> TraceRecorder::take() {
  std::map<int, FaceTrace> faces;
  for (auto& [face, recorder] : recorders_) faces[face] = std::move(recorder.entries);
  recorders_.clear();
  return faces;
}

}  // namespace af2::cli
