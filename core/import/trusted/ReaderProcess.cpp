#include "import/trusted/ReaderProcess.h"

#include "base/Budgets.h"
#include "base/Error.h"
#include "base/OneLine.h"
#include "base/SanitizerFindings.h"
#include "base/ShippedFolders.h"
#include "base/SuspendAwareTimer.h"
#include "model/ModelFormats.h"
#include "model/StoredModel.h"

#include <QCoreApplication>
#include <QDataStream>
#include <QFileInfo>
#include <QProcess>
#include <QSet>
#include <QtEndian>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ReaderProcess)
};

constexpr qint64 chunk = 1 << 20;       // bytes of a file per write
constexpr qint64 longestText = 1 << 16; // bytes of a name or message
constexpr qsizetype longestUnit = 20, longestFaceName = 200;
constexpr int pollInterval = 50; // ms between checks for cancellation

// Passes on only the environment variables that are needed to find and test programs.
QProcessEnvironment bareEnvironment() {
    const QProcessEnvironment all = QProcessEnvironment::systemEnvironment();
    QProcessEnvironment bare;
    for (const char* name :
         {"LD_LIBRARY_PATH", "PATH", "SystemRoot", "QT_PLUGIN_PATH", "DIPWRIGHT_READ_UNCONFINED",
          "ASAN_OPTIONS", "UBSAN_OPTIONS", "TSAN_OPTIONS"}) {
        const QString key = QString::fromLatin1(name);
        if (all.contains(key)) {
            bare.insert(key, all.value(key));
        }
    }
    return bare;
}

// Makes the text of another process safe to show: one line, no escape bytes, limited length.
QString sanitized(const QByteArray& text) {
    return oneLine(QString::fromUtf8(text.left(longestText))).simplified().left(2000);
}

// Returns the timeout in ms for files of `fileBytes` bytes. The operating system limits the
// reader's processor time (app/reader/Sandbox.h), so only a reader that waits for ever reaches the
// timeout.
qint64 timeout(Budget computing, qint64 fileBytes) {
    constexpr int busyMachine = 40; // factor on the computing time
    return busyMachine * budgetLimit(computing, fileBytes);
}

class ReaderProcess {
public:
    enum class Reads { Usual, Cad };

    ReaderProcess(const QString& where, UntrustedFiles& files, const Progress& progress,
                  Reads reads = Reads::Usual)
        : where_(where), files_(files), progress_(progress), isCad_(reads == Reads::Cad) {}
    // Kills the process: it has returned everything, or its result is no longer needed.
    ~ReaderProcess() {
        process_.kill();
        process_.waitForFinished();
        endOnFinding(process_);
    }

    void start(const ReaderJob& job) {
        const QString program = isCad_ ? cadReaderProgram() : readerProgram();
        if (program.isEmpty() && isCad_) {
            throw Error(
                Text::tr("This Dipwright was built without the reader of CAD files; save "
                         "the model as %1, or use a Dipwright with CAD (dipwright-cad-reader)")
                    .arg(anyModelFormat()),
                where_);
        }
        if (program.isEmpty()) {
            throw Error(Text::tr("The program that reads models and pictures is missing; "
                                 "reinstall Dipwright"),
                        QStringLiteral("dipwright-reader"));
        }
        process_.setProcessEnvironment(bareEnvironment());
        silence(process_);
        process_.start(program, {}, QIODevice::ReadWrite);
        if (!process_.waitForStarted()) {
            throw Error(Text::tr("The program that reads models and pictures cannot be started: %1")
                            .arg(process_.errorString()),
                        program);
        }
        waited_ = SuspendAwareTimer();
        const QByteArray bytes = jobBytes(job);
        write(headerBytes(ReaderMessage::Job, bytes.size()) + bytes);
    }

    // Handles messages until one is part of the result. Returns its kind and the length of the data
    // that is still to be read.
    std::pair<ReaderMessage, qint64> nextResult() {
        while (true) {
            const auto [kind, length] = readHeader(read(readerHeaderBytes));
            requireInTime(); // a process that sends messages for ever counts as hanging, too
            switch (kind) {
            case ReaderMessage::Ask:
                answer(QString::fromUtf8(readShort(length)));
                break;
            case ReaderMessage::Progress:
                report(readShort(length));
                break;
            case ReaderMessage::Failed:
                fail(readShort(length));
            case ReaderMessage::Photo:
            case ReaderMessage::Picture:
            case ReaderMessage::Inks:
            case ReaderMessage::Cad:
            case ReaderMessage::Model:
            case ReaderMessage::Mesh:
                return {kind, length};
            default:
                throwInvalidData();
            }
        }
    }

    QByteArray read(qint64 length) {
        const Budget memory = isCad_ ? Budget::CadMemory : Budget::Memory;
        if (length > budgetLimit(memory, files_.bytesRead())) {
            throwInvalidData();
        }
        QByteArray bytes(length, Qt::Uninitialized);
        read(bytes.data(), length);
        return bytes;
    }

    PhotoFacts readFacts(qint64 length) {
        PhotoFacts facts = dipwright::readFacts(readShort(length));
        facts.taken = sanitized(facts.taken.toUtf8());
        return facts;
    }

    CadFacts readCadFacts(qint64 length) {
        CadFacts facts = dipwright::readCadFacts(readShort(length));
        facts.unit = sanitized(facts.unit.toUtf8()).left(longestUnit);
        if (!(facts.tessellation >= finestTessellation &&
              facts.tessellation <= coarsestTessellation)) {
            throwInvalidData();
        }
        return facts;
    }

    QImage readPicture(qint64 length) {
        QImage picture;
        if (length > pictureHeaderLength) {
            const QByteArray header = read(pictureHeaderLength);
            const auto side = [&](int place) {
                return qint64(qFromLittleEndian<qint32>(header.constData() + 4 * place));
            };
            const bool wide = side(4) != 0;
            pixels_ += (wide ? 2 : 1) * std::max(side(0), qint64(0)) * std::max(side(1), qint64(0));
            requireWithin(Budget::Pixels, pixels_, where_, files_.bytesRead());
            picture = emptyPicture(header);
        }
        if (picture.isNull() || length != pictureHeaderLength + picture.sizeInBytes()) {
            throwInvalidData();
        }
        read(reinterpret_cast<char*>(picture.bits()), picture.sizeInBytes());
        return picture;
    }

    [[noreturn]] void throwInvalidData() const {
        throw Error(Text::tr("The file was not read, because the file reader returned invalid data "
                             "for it; save it again"),
                    where_);
    }

private:
    void read(char* bytes, qint64 length) {
        while (length > 0) {
            const qint64 got = process_.read(bytes, length);
            if (got > 0) {
                bytes += got;
                length -= got;
            } else {
                process_.waitForReadyRead(pollInterval);
                checkAlive();
            }
        }
    }

    void write(const QByteArray& bytes) {
        process_.write(bytes);
        while (process_.bytesToWrite() > 0) {
            requireInTime();
            if (!process_.waitForBytesWritten(pollInterval)) {
                checkAlive();
            }
        }
    }

    QByteArray readShort(qint64 length) {
        if (length > longestText) {
            throwInvalidData();
        }
        return read(length);
    }

    void answer(const QString& name) {
        const auto bytes = files_.read(name);
        if (!bytes) {
            write(headerBytes(ReaderMessage::NoFile, 0));
            return;
        }
        write(headerBytes(ReaderMessage::File, bytes->size()));
        for (qint64 begin = 0; begin < bytes->size(); begin += chunk) {
            write(bytes->mid(begin, chunk));
        }
    }

    void report(const QByteArray& bytes) {
        double share = 0;
        QByteArray text;
        QDataStream stream(bytes);
        stream >> share >> text;
        progress_(share >= 0 && share <= 1 ? share : 0, sanitized(text));
    }

    [[noreturn]] void fail(const QByteArray& bytes) {
        QByteArray message, where;
        QDataStream stream(bytes);
        stream >> message >> where;
        throw Error(sanitized(message), sanitized(where));
    }

    void requireInTime() {
        const std::chrono::milliseconds patience(timeout(time(), files_.bytesRead()));
        if (waited_.look() > patience) {
            throwOutOfTime();
        }
    }

    [[noreturn]] void throwOutOfTime() const {
        throw Error(sentenceOf(time(), files_.bytesRead()), where_);
    }

    Budget time() const { return isCad_ ? Budget::CadMilliseconds : Budget::Milliseconds; }

    // Throws if the process can return nothing more: cancelled, out of time or ended.
    void checkAlive() {
        progress_.cancelToken.throwIfCancelled();
        requireInTime();
        if (process_.bytesAvailable() > 0) {
            return;
        }
        const bool hasEnded = process_.state() == QProcess::NotRunning;
        if (hasEnded && process_.exitStatus() == QProcess::NormalExit &&
            process_.exitCode() == readerOutOfTime) {
            throwOutOfTime();
        }
        if (hasEnded && isCad_) {
            throw Error(Text::tr("The CAD file was not read, because it made the file reader "
                                 "crash; save it again as STEP (AP214 or AP242) in the CAD "
                                 "program"),
                        where_);
        }
        if (hasEnded) {
            throw Error(Text::tr("The file was not read, because it made the file reader crash; "
                                 "save it again (a model as %1, a picture as PNG)")
                            .arg(anyModelFormat()),
                        where_);
        }
    }

    QString where_;
    UntrustedFiles& files_;
    const Progress& progress_;
    bool isCad_;
    QProcess process_;
    SuspendAwareTimer waited_;
    qint64 pixels_ = 0;
};

//: The code of the language of this translation: de, pt_BR …
QString language() {
    return Text::tr("en");
}

// Returns the model that a reader sends. `path` is for messages.
UntrustedModel receivedModel(ReaderProcess& reader, const QString& path) {
    UntrustedModel model;
    std::vector<QImage> pictures, inks;
    while (true) {
        const auto [kind, length] = reader.nextResult();
        if (kind == ReaderMessage::Picture) {
            pictures.push_back(reader.readPicture(length));
        } else if (kind == ReaderMessage::Inks) {
            inks.resize(pictures.size() + 1);
            inks.back() = reader.readPicture(length);
        } else if (kind == ReaderMessage::Cad) {
            model.cad = reader.readCadFacts(length);
        } else if (kind == ReaderMessage::Model) {
            const QByteArray warnings = reader.read(length);
            for (const QByteArray& warning : warnings.split('\n')) {
                if (!warning.isEmpty()) {
                    model.warnings << sanitized(warning);
                }
            }
        } else if (kind != ReaderMessage::Mesh) {
            reader.throwInvalidData();
        } else {
            StoredModel stored = readUncheckedModel(reader.read(length), path);
            if (stored.pictures.size() != pictures.size()) {
                reader.throwInvalidData();
            }
            model.mesh = std::move(stored.model);
            if (!inks.empty()) {
                inks.resize(pictures.size());
            }
            model.mesh.textures = std::move(pictures);
            model.mesh.inks = std::move(inks);
            return model;
        }
    }
}

} // namespace

UntrustedModel readModelInProcess(const QString& path, bool withTextures, UntrustedFiles& files,
                                  const Progress& progress) {
    ReaderProcess reader(path, files, progress);
    reader.start({ReaderJob::Kind::Model, {path}, withTextures, language()});
    return receivedModel(reader, path);
}

UntrustedModel readCadInProcess(const QString& path, const Tessellation& tessellation,
                                UntrustedFiles& files, const Progress& progress) {
    ReaderProcess reader(path, files, progress, ReaderProcess::Reads::Cad);
    reader.start({ReaderJob::Kind::Model, {path}, false, language(), tessellation});
    UntrustedModel model = receivedModel(reader, path);
    if (!model.cad) {
        reader.throwInvalidData();
    }
    QSet<QString> taken{QString()}; // no face is without a name
    for (Material& material : model.mesh.materials) {
        material.name = sanitized(material.name.toUtf8()).left(longestFaceName);
        if (taken.contains(material.name)) {
            reader.throwInvalidData();
        }
        taken.insert(material.name);
    }
    return model;
}

std::vector<ReadPicture> readPicturesInProcess(const QStringList& names, UntrustedFiles& files) {
    if (names.isEmpty()) {
        return {};
    }
    const Progress quiet;
    ReaderProcess reader(names.first(), files, quiet);
    reader.start({ReaderJob::Kind::Pictures, names, true, language()});
    std::vector<ReadPicture> pictures;
    QImage inks; // of the next picture
    while (qsizetype(pictures.size()) < names.size()) {
        const auto [kind, length] = reader.nextResult();
        if (kind == ReaderMessage::Inks) {
            inks = reader.readPicture(length);
        } else if (kind == ReaderMessage::Picture) {
            pictures.push_back({reader.readPicture(length), std::exchange(inks, {})});
        } else {
            reader.throwInvalidData();
        }
    }
    return pictures;
}

ReadPhoto readPhotoInProcess(const QString& name, UntrustedFiles& files, const Progress& progress) {
    ReaderProcess reader(name, files, progress);
    reader.start({ReaderJob::Kind::Photos, {name}, true, language()});
    ReadPhoto photo;
    const auto expect = [&](ReaderMessage expected) {
        const auto [kind, length] = reader.nextResult();
        if (kind != expected) {
            reader.throwInvalidData();
        }
        return length;
    };
    photo.facts = reader.readFacts(expect(ReaderMessage::Photo));
    photo.picture = reader.readPicture(expect(ReaderMessage::Picture));
    return photo;
}

} // namespace dipwright
