#include "workbench/document/ImmersionEdits.h"

#include "base/Error.h"
#include "dip/PathKeys.h"
#include "dip/Pose.h"

#include <QCoreApplication>
#include <cmath>

namespace dipwright {

void addImmersion(Document& document) {
    document.edit(
        QCoreApplication::translate("ImmersionEdits", "Add dip"), {}, [](Project& project) {
            Immersion second = project.immersions.front();
            second.name = QCoreApplication::translate("ImmersionEdits", "Dip %1").arg(2);
            second.rotation[0] = Degrees(std::remainder(second.rotation[0].value() + 180, 360));
            project.immersions.push_back(second);
        });
}

void removeImmersion(Document& document, std::size_t number) {
    document.edit(QCoreApplication::translate("ImmersionEdits", "Remove dip"), {},
                  [number](Project& project) {
                      project.immersions.erase(project.immersions.begin() + std::ptrdiff_t(number));
                  });
}

void setImmersions(Document& document, const std::vector<Immersion>& immersions) {
    document.edit(QCoreApplication::translate("ImmersionEdits", "Use pose"), {},
                  [&immersions](Project& project) { project.immersions = immersions; });
}

void tryImmersions(Document& document, const std::vector<Immersion>& immersions) {
    document.edit(QCoreApplication::translate("ImmersionEdits", "Try poses"),
                  QStringLiteral("tried poses"),
                  [&immersions](Project& project) { project.immersions = immersions; });
}

namespace {

TriangleMesh posedModel(const Project& project, const Immersion& immersion) {
    const TriangleMesh& mesh = project.model->mesh;
    return transformed(mesh, poseTransform(mesh, immersion));
}

} // namespace

void fillPoses(Project& project, const Project& before) {
    for (std::size_t dip = 0; dip < project.immersions.size(); ++dip) {
        DipPath& path = project.immersions[dip].path;
        if (path.kind != PathKind::Poses || dip >= before.immersions.size() ||
            before.immersions[dip].path.kind == PathKind::Poses) {
            continue;
        }
        Immersion source = before.immersions[dip];
        try {
            path.keys = asPoses(posedModel(before, source), source, before.process).keys;
        } catch (const Error&) { // that path cannot be travelled
            source.path = {};
            path.keys = asPoses(posedModel(before, source), source, before.process).keys;
        }
    }
}

void addPathKey(Document& document, std::size_t dip, std::size_t before) {
    const Millimetres depth = depthOf(document.project(), dip);
    document.edit(QCoreApplication::translate("ImmersionEdits", "Add pose to path"), {},
                  [&](Project& changed) {
                      std::vector<PathKey>& keys = changed.immersions[dip].path.keys;
                      keys.insert(keys.begin() + std::ptrdiff_t(before) + 1,
                                  middleKey(keys[before], keys[before + 1], depth));
                  });
}

void removePathKey(Document& document, std::size_t dip, std::size_t key) {
    document.edit(QCoreApplication::translate("ImmersionEdits", "Remove pose from path"), {},
                  [&](Project& project) {
                      std::vector<PathKey>& keys = project.immersions[dip].path.keys;
                      keys.erase(keys.begin() + std::ptrdiff_t(key));
                  });
}

Millimetres depthOf(const Project& project, std::size_t dip) {
    const ProcessSettings& process = project.process;
    return process.depth
               ? *process.depth
               : Millimetres(dipDepth(
                     process,
                     boundingBox(posedModel(project, project.immersions[dip])).sizes().y()));
}

void swapImmersions(Document& document) {
    document.edit(QCoreApplication::translate("ImmersionEdits", "Swap dips"), {},
                  [](Project& project) {
                      std::swap(project.immersions.front(), project.immersions.back());
                      for (ShareMark& mark : project.share.marks) {
                          mark.kind = mark.kind == ShareMarkKind::First    ? ShareMarkKind::Second
                                      : mark.kind == ShareMarkKind::Second ? ShareMarkKind::First
                                                                           : mark.kind;
                      }
                  });
}

} // namespace dipwright
