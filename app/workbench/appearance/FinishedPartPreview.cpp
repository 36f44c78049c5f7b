#include "workbench/appearance/FinishedPartPreview.h"

namespace dipwright {
namespace {

constexpr double paperTriangles = 150'000; // approximate

} // namespace

FinishedPartPreview::FinishedPartPreview(QObject* parent) : QObject(parent) {}

FinishedPartPreview::Paper
FinishedPartPreview::meshedModel(const std::shared_ptr<const TexturedMesh>& model) {
    const auto mesh = std::make_shared<const RefinedMesh>(
        model->mesh, edgeForTriangles(model->mesh, paperTriangles));
    return {model, mesh, plainBody(*mesh)};
}

void FinishedPartPreview::print(const std::shared_ptr<const TexturedMesh>& model,
                                std::vector<FilmAppearance> films, const InkSettings& ink,
                                const Ground& ground) {
    jobs_.cancelAll();
    jobs_.start(std::make_unique<ValueJob<Print>>(
        tr("Computing the finished part"),
        [paper = paper_, model, films = std::move(films), ink, ground](const Progress&) {
            Print print{paper.model == model ? paper : meshedModel(model), {}};
            print.colours = printedColours(*print.paper.mesh, films, ink, ground);
            return print;
        },
        [this](const Print& print) {
            paper_ = print.paper;
            emit printed(print.paper.model, {print.paper.body, print.colours});
        },
        [](const std::exception_ptr&) {})); // on failure, keeps the view
}

} // namespace dipwright
