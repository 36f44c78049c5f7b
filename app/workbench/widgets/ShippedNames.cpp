#include "workbench/widgets/ShippedNames.h"

#include <QCoreApplication>

namespace dipwright {

namespace {

// For lupdate only.
[[maybe_unused]] constexpr const char* shipped[] = {
    QT_TRANSLATE_NOOP("ShippedNames", "Ideal film, A3"),
    QT_TRANSLATE_NOOP("ShippedNames", "Ideal film, A4"),
    QT_TRANSLATE_NOOP("ShippedNames", "Soft film, A4, swells by 5 %"),
    QT_TRANSLATE_NOOP("ShippedNames", "Pigment printer, borderless, 600 dpi"),
    QT_TRANSLATE_NOOP("ShippedNames", "Office printer, 5 mm margins"),
    QT_TRANSLATE_NOOP("ShippedNames", "True size, sRGB"),
    QT_TRANSLATE_NOOP("ShippedNames", "Tank with barriers on all sides"),
    QT_TRANSLATE_NOOP("ShippedNames", "Open tank"),
    QT_TRANSLATE_NOOP("ShippedNames", "Position-based film on the CPU"),
    QT_TRANSLATE_NOOP("ShippedNames", "Position-based film on an NVIDIA GPU"),
    QT_TRANSLATE_NOOP("ShippedNames", "No NVIDIA driver was found on this computer; install one to "
                                      "compute on the GPU."),
    QT_TRANSLATE_NOOP("ShippedNames", "No NVIDIA GPU was found on this computer."),
    QT_TRANSLATE_NOOP("ShippedNames", "Sphere"),
    QT_TRANSLATE_NOOP("ShippedNames", "Tetrahedron"),
    QT_TRANSLATE_NOOP("ShippedNames", "Turtle"),
    QT_TRANSLATE_NOOP("ShippedNames", "Lagoon"),
    QT_TRANSLATE_NOOP("ShippedNames", "Dusk"),
    QT_TRANSLATE_NOOP("ShippedNames", "Balance"),
    QT_TRANSLATE_NOOP("ShippedNames", "Grey"),
};

} // namespace

QString shownName(const QString& name) {
    return QCoreApplication::translate("ShippedNames", name.toUtf8().constData());
}

QString shownTitle(const QString& identifier) {
    return shownName(identifier.left(1).toUpper() + identifier.mid(1));
}

} // namespace dipwright
