#include "model/ModelFormats.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ModelFormats)
};

QStringList names() {
    QStringList all;
    for (const ModelFormat& format : modelFormats()) {
        all.push_back(format.name);
    }
    return all;
}

} // namespace

const std::vector<ModelFormat>& modelFormats() {
    static const std::vector<ModelFormat> formats{
        {QStringLiteral("OBJ"), {QStringLiteral("obj")}},
        {QStringLiteral("PLY"), {QStringLiteral("ply")}},
        {QStringLiteral("STL"), {QStringLiteral("stl")}},
        {QStringLiteral("glTF"), {QStringLiteral("gltf"), QStringLiteral("glb")}},
        {QStringLiteral("3MF"), {QStringLiteral("3mf")}},
        {QStringLiteral("Collada"), {QStringLiteral("dae")}},
        {QStringLiteral("FBX"), {QStringLiteral("fbx")}},
        {QStringLiteral("3DS"), {QStringLiteral("3ds")}},
#ifdef DIPWRIGHT_CAD
        {QStringLiteral("STEP"), {QStringLiteral("step"), QStringLiteral("stp")}},
        {QStringLiteral("IGES"), {QStringLiteral("iges"), QStringLiteral("igs")}},
#endif
    };
    return formats;
}

bool isCadFile(const QString& path) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    for (const char* cad : {"step", "stp", "iges", "igs"}) {
        if (suffix == QLatin1String(cad)) {
            return true;
        }
    }
    return false;
}

bool namesUnit(const QString& path) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    return isCadFile(path) || suffix == QLatin1String("dae") || suffix == QLatin1String("fbx") ||
           suffix == QLatin1String("3mf");
}

QStringList modelFilePatterns() {
    QStringList patterns;
    for (const ModelFormat& format : modelFormats()) {
        for (const QString& suffix : format.suffixes) {
            patterns.push_back(QStringLiteral("*.%1").arg(suffix));
        }
    }
    return patterns;
}

QString modelFormatNames() {
    return names().join(QStringLiteral(", "));
}

QString anyModelFormat() {
    QStringList all = names();
    const QString last = all.takeLast();
    //: Names of file formats: "OBJ, PLY, STL, glTF" or "3MF"
    return Text::tr("%1 or %2").arg(all.join(QStringLiteral(", ")), last);
}

} // namespace dipwright
