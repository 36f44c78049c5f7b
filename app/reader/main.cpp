// dipwright-reader: reads one foreign model, or some pictures, in a sandbox and sends the result
// back. Started by core/import/trusted/ReaderProcess, not by users.
#include "base/Budgets.h"
#include "import/sandboxed/PhotoFacts.h"
#include "import/sandboxed/PictureReader.h"
#include "import/sandboxed/UntrustedModel.h"
#include "reader/Pipe.h"
#include "reader/Sandbox.h"

#include <QCoreApplication>
#include <QTranslator>

#include <cstdlib>
#include <new>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Reader)
};

// Returns whether the user has allowed reading without a sandbox. Meant for systems without one and
// for trusted files.
bool mayReadUnconfined() {
    return qEnvironmentVariableIsSet("DIPWRIGHT_READ_UNCONFINED");
}

void readModel(const ReaderJob& job, Pipe& pipe) {
    const Progress progress{
        [&pipe](double share, const QString& text) { pipe.report(share, text); }, {}};
    const UntrustedModel model =
        readUntrustedModel(job.names.value(0), pipe, job.withTextures, progress);
    for (std::size_t texture = 0; texture < model.mesh.textures.size(); ++texture) {
        pipe.hand(model.mesh.textures[texture], model.mesh.inks[texture]);
    }
    pipe.hand(model);
}

void readPictures(const ReaderJob& job, Pipe& pipe) {
    PictureReader reader;
    for (const QString& name : job.names) {
        const QImage picture = reader.read(pipe.read(name).value_or(QByteArray()), name);
        pipe.hand(picture, reader.inksOf(picture));
    }
}

void readPhotos(const ReaderJob& job, Pipe& pipe) {
    PictureReader reader;
    for (const QString& name : job.names) {
        const QByteArray bytes = pipe.read(name).value_or(QByteArray());
        pipe.hand(photoFacts(bytes));
        pipe.hand(reader.read(bytes, name, PictureReader::Turned::Upright));
    }
}

void read(const ReaderJob& job, Pipe& pipe) {
    try {
        switch (job.kind) {
        case ReaderJob::Kind::Model:
            return readModel(job, pipe);
        case ReaderJob::Kind::Pictures:
            return readPictures(job, pipe);
        case ReaderJob::Kind::Photos:
            return readPhotos(job, pipe);
        }
    } catch (const Error& error) {
        pipe.fail(error);
    } catch (const std::bad_alloc&) {
        pipe.fail(Error(sentenceOf(Budget::Memory, pipe.bytesRead()), job.names.value(0)));
    }
}

} // namespace
} // namespace dipwright

int main(int argc, char* argv[]) {
    using namespace dipwright;
    closeInheritedFiles();
    const QCoreApplication application(argc, argv);
    Pipe pipe;
    const ReaderJob job = pipe.readJob();
    QTranslator translator;
    if (translator.load(QStringLiteral(":/translations/dipwright_") + job.language)) {
        QCoreApplication::installTranslator(&translator);
    }
    PictureReader::prepare();
    if (enterSandbox() || mayReadUnconfined()) {
        read(job, pipe);
    } else {
        pipe.fail(Error(Text::tr("This operating system cannot run the reader of models and "
                                 "pictures in a sandbox, so nothing was read. Use another system, "
                                 "or set DIPWRIGHT_READ_UNCONFINED=1 for files that you trust"),
                        job.names.value(0)));
    }
    // Skips all clean-up, because a foreign file may have corrupted the memory.
    std::_Exit(EXIT_SUCCESS);
}
