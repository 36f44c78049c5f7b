#include "import/sandboxed/UntrustedModel.h"

#include "base/Budgets.h"
#include "import/sandboxed/AssimpReader.h"
#include "import/sandboxed/ColladaCheck.h"
#include "import/sandboxed/ModelSource.h"
#include "import/sandboxed/PlyReader.h"
#include "import/sandboxed/ThreeMfReader.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

// Returns the format: PLY and COLLADA by the file's first bytes, every other format by the file's
// name.
QString formatOf(const ModelSource& source) {
    constexpr qsizetype longestPrologue = 4096;
    const QByteArray begin = source.bytes.left(longestPrologue);
    if (begin.startsWith("ply\n") || begin.startsWith("ply\r")) {
        return QStringLiteral("ply");
    }
    if (isCollada(begin)) {
        return QStringLiteral("dae");
    }
    return QFileInfo(source.path).suffix().toLower();
}

} // namespace

UntrustedModel readUntrustedModel(const QString& path, UntrustedFiles& files, bool withTextures,
                                  const Progress& progress) {
    progress(0, Text::tr("Reading the model"));
    PictureReader pictures;
    const auto bytes = files.read(path);
    const ModelSource source{path, bytes.value_or(QByteArray()), files, pictures, withTextures};
    if (!bytes) {
        source.throwDamaged(Text::tr("the file cannot be opened"));
    }
    const QString format = formatOf(source);
    UntrustedModel model;
    if (format == QStringLiteral("ply")) {
        model.mesh = readPly(source, model.warnings, progress.cancelToken);
    } else if (format == QStringLiteral("3mf")) {
        model.mesh = readThreeMf(source, model.warnings, progress.cancelToken);
    } else {
        if (format == QStringLiteral("dae")) {
            checkCollada(source);
        }
        model.mesh = readByAssimp(format, source, model.warnings, progress);
    }
    for (const QImage& texture : model.mesh.textures) {
        model.mesh.inks.push_back(pictures.inksOf(texture));
    }
    requireWithin(Budget::Triangles, qint64(model.mesh.mesh.triangles.size()), path,
                  files.bytesRead());
    return model;
}

} // namespace dipwright
