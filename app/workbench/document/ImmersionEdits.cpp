#include "workbench/document/ImmersionEdits.h"

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
