#include "geometry/occ/algorithms/general_fuse.h"

#include <BOPAlgo_Builder.hxx>
#include <BOPAlgo_BuilderSolid.hxx>
#include <BOPTools_AlgoTools.hxx>
#include <IntTools_Context.hxx>
#include <Message_Alert.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Message_Report.hxx>
#include <Standard_Failure.hxx>
#include <TopTools_ListOfShape.hxx>
#include <chrono>
#include <cstdio>
#include <new>
#include <string>

#include "engine/base/error.h"

namespace af2::geometry {

namespace {

/// Asks OpenCASCADE to stop when time is up, or when the caller wants it.
class FuseLimit : public Message_ProgressIndicator {
  DEFINE_STANDARD_RTTI_INLINE(FuseLimit, Message_ProgressIndicator)

 public:
  FuseLimit(double seconds, std::stop_token stop)
      : end_(std::chrono::steady_clock::now() +
             std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                 std::chrono::duration<double>(seconds))),
        stop_(std::move(stop)) {}
  bool isOver() const { return std::chrono::steady_clock::now() > end_; }
  bool isStopped() const { return stop_.stop_requested(); }

 protected:
  bool UserBreak() override { return isStopped() || isOver(); }
  void Show(const Message_ProgressScope&, bool) override {}

 private:
  std::chrono::steady_clock::time_point end_;
  std::stop_token stop_;
};

std::string errorOf(const BOPAlgo_Builder& builder) {
  const Message_ListOfAlert& errors = builder.GetReport()->GetAlerts(Message_Fail);
  return errors.IsEmpty() ? "" : errors.First()->DynamicType()->Name();
}

[[noreturn]] void throwFailure(const std::string& what, const FuseLimit& limit, double seconds) {
  if (limit.isStopped()) throw GeometryError("it was stopped");
  if (!limit.isOver()) throw GeometryError("OpenCASCADE's general fuse failed (" + what + ")");
  char text[64];
  std::snprintf(text, sizeof text, "it took longer than %g seconds", seconds);
  throw GeometryError(text);
}

class BuilderFuse final : public GeneralFuse {
 public:
  BuilderFuse(const std::vector<TopoDS_Shape>& arguments, const FuseOptions& options) {
    TopTools_ListOfShape list;
    for (const TopoDS_Shape& argument : arguments) list.Append(argument);
    builder_.SetArguments(list);
    builder_.SetRunParallel(false);
    builder_.SetNonDestructive(true);
    builder_.SetFuzzyValue(options.tolerance);
    builder_.SetGlue(options.glue);
    const Handle(FuseLimit) limit = new FuseLimit(options.seconds, options.stop);
    try {
      builder_.Perform(limit->Start());
    } catch (const Standard_Failure& failure) {
      throwFailure(failure.DynamicType()->Name(), *limit, options.seconds);
    } catch (const std::bad_alloc&) {
      throwFailure("out of memory", *limit, options.seconds);
    }
    if (builder_.HasErrors() || limit->isOver() || limit->isStopped())
      throwFailure(errorOf(builder_), *limit, options.seconds);
  }

  std::vector<TopoDS_Shape> piecesOf(const TopoDS_Shape& shape) override {
    const TopTools_ListOfShape& pieces = builder_.Modified(shape);
    if (!pieces.IsEmpty()) return {pieces.begin(), pieces.end()};
    if (builder_.IsDeleted(shape)) return {};
    return {shape};
  }

 private:
  BOPAlgo_Builder builder_;
};

}  // namespace

std::unique_ptr<GeneralFuse> fuseShapes(const std::vector<TopoDS_Shape>& arguments,
                                        const FuseOptions& options) {
  return std::make_unique<BuilderFuse>(arguments, options);
}

std::vector<TopoDS_Shape> solidsBetween(const std::vector<TopoDS_Shape>& faces) {
  TopTools_ListOfShape list;
  for (const TopoDS_Shape& face : faces) list.Append(face);
  BOPAlgo_BuilderSolid builder;
  builder.SetShapes(list);
  builder.SetAvoidInternalShapes(true);
  builder.Perform();
  if (builder.HasErrors() || builder.Areas().IsEmpty())
    throw GeometryError("the pieces of a solid could not be joined");
  return {builder.Areas().begin(), builder.Areas().end()};
}

bool isTurned(const TopoDS_Shape& piece, const TopoDS_Shape& face) {
  return BOPTools_AlgoTools::IsSplitToReverse(piece, face, new IntTools_Context);
}

}  // namespace af2::geometry
