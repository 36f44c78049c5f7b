// dipwright-reader: reads one foreign model, or some pictures, in a sandbox and sends the result
// back. Started by core/import/trusted/ReaderProcess, not by users.
#include "import/sandboxed/PhotoFacts.h"
#include "import/sandboxed/PictureReader.h"
#include "import/sandboxed/UntrustedModel.h"
#include "reader/Reader.h"

namespace dipwright {
namespace {

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

void readFiles(const ReaderJob& job, Pipe& pipe) {
    switch (job.kind) {
    case ReaderJob::Kind::Model:
        return readModel(job, pipe);
    case ReaderJob::Kind::Pictures:
        return readPictures(job, pipe);
    case ReaderJob::Kind::Photos:
        return readPhotos(job, pipe);
    }
}

} // namespace
} // namespace dipwright

int main(int argc, char* argv[]) {
    using namespace dipwright;
    runReader(argc, argv, {{}, &PictureReader::prepare, &readFiles});
}
