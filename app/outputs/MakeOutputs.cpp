#include "outputs/MakeOutputs.h"

#include "base/Error.h"
#include "base/JsonText.h"
#include "base/Sha256.h"
#include "disk/AtomicFile.h"
#include "disk/FolderTransaction.h"
#include "disk/PlainFile.h"
#include "model/ModelHash.h"
#include "pipeline/WriteResults.h"
#include "printing/PrintFile.h"
#include "project/Project.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QHash>
#include <QJsonDocument>
#include <QJsonObject>
#include <QScopeGuard>

#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Outputs)
};

const QString recordFile = QStringLiteral("outputs.json");
const QString projectKey = QStringLiteral("project");
const QString filesKey = QStringLiteral("files");
constexpr qint64 longestRecord = 1 << 20; // bytes

// Identifies the state of the project that outputs are made from. Its own hash of the model is of
// the saved mesh only.
QString stateOf(const Project& project) {
    QJsonObject settings = countedSettings(project);
    QJsonObject model = settings[QLatin1String("model")].toObject();
    model[QLatin1String("sha256")] = modelHash(project.model);
    settings[QLatin1String("model")] = model;
    return sha256Hex(QJsonDocument(settings).toJson(QJsonDocument::Compact));
}

// Returns the file's hash; empty if it cannot be read.
QString hashOf(const QString& path) {
    QFile file(path);
    if (!openToRead(file).isEmpty()) {
        return {};
    }
    Sha256 hash;
    constexpr qint64 piece = 1 << 20;
    while (!file.atEnd()) {
        const QByteArray bytes = file.read(piece);
        if (bytes.isEmpty()) {
            return {};
        }
        hash.add(bytes);
    }
    return QString::fromLatin1(hash.result().toHex());
}

// Returns the folder's record: for each output's word, the state of the project and the hash of
// each file. Empty if there is none.
QJsonObject recordIn(const QString& folder) {
    QFile file(QDir(folder).filePath(recordFile));
    if (!QFileInfo::exists(file.fileName()) || !openToRead(file).isEmpty()) {
        return {};
    }
    const QByteArray bytes = file.read(longestRecord);
    try {
        requireJsonWithinLimits(bytes, file.fileName());
        return QJsonDocument::fromJson(bytes).object();
    } catch (const Error&) {
        return {};
    }
}

QJsonObject filesIn(const QJsonObject& record, Output output) {
    return record[outputWord(output)][filesKey].toObject();
}

QStringList existingFiles(const QString& folder, Output output) {
    QStringList files = outputFiles(output);
    files.removeIf(
        [&](const QString& file) { return !QFileInfo::exists(QDir(folder).filePath(file)); });
    return files;
}

// Returns when the file was changed last.
QDateTime changeOf(const QString& folder, const QString& file) {
    return QFileInfo(QDir(folder).filePath(file)).lastModified();
}

OutputStatus stateIn(const QString& folder, const QJsonObject& record, Output output,
                     const QString& state) {
    OutputStatus status;
    status.output = output;
    const QJsonObject files = filesIn(record, output);
    status.files = files.keys();
    const bool isWhole =
        !files.isEmpty() && std::ranges::all_of(status.files, [&](const QString& file) {
            return hashOf(QDir(folder).filePath(file)) == files[file].toString();
        });
    if (isWhole) {
        status.state = record[outputWord(output)][projectKey].toString() == state
                           ? OutputState::Done
                           : OutputState::OutOfDate;
    }
    return status;
}

QStringList writePrintFiles(const JobResult& result, Output output, const OutputRequest& request,
                            const Progress& progress) {
    PrintFileRequest file;
    file.profile = result.project.profiles.printer;
    file.acceptClipping = request.acceptsClipping;
    file.source = printSource(result.project, request.projectFile);
    const QStringList names = outputFiles(output);
    const auto removeEmptyFolders = qScopeGuard([&] {
        for (const QString& name : names) {
            QDir(request.folder).rmdir(QFileInfo(name).path()); // fails unless it is empty
        }
    });
    QStringList notes;
    for (std::size_t i = 0; i < result.immersions.size(); ++i) {
        const ImmersionResult& dip = result.immersions[i];
        progress(double(i) / double(result.immersions.size()),
                 Text::tr("Writing the sheet of %1").arg(dip.immersion.name));
        progress.cancelToken.throwIfCancelled();
        const QString path = QDir(request.folder).filePath(names.at(int(i)));
        if (!QDir().mkpath(QFileInfo(path).path())) {
            throw Error(Text::tr("The folder cannot be created; choose another one"),
                        QFileInfo(path).path());
        }
        notes += writePrintFile(dip.sheet, file, path, PrintHistory());
    }
    for (int i = int(result.immersions.size()); i < names.size(); ++i) {
        QFile::remove(QDir(request.folder).filePath(names.at(i))); // of a dip that is gone
    }
    notes.removeDuplicates();
    return notes;
}

void keepRecord(const QString& folder, const JobResult& result, const OutputStatus& status) {
    QJsonObject files;
    for (const QString& file : status.files) {
        files[file] = hashOf(QDir(folder).filePath(file));
    }
    QJsonObject record = recordIn(folder);
    record[outputWord(status.output)] =
        QJsonObject{{projectKey, stateOf(result.project)}, {filesKey, files}};
    writeAtomically(QDir(folder).filePath(recordFile),
                    [&](QIODevice& device) { device.write(QJsonDocument(record).toJson()); });
}

OutputStatus made(const JobResult& result, Output output, const OutputRequest& request,
                  const Progress& progress) {
    OutputStatus status;
    status.output = output;
    QHash<QString, QDateTime> before;
    for (const QString& file : existingFiles(request.folder, output)) {
        before[file] = changeOf(request.folder, file);
    }
    try {
        const QStringList foreign = foreignFiles(request.folder, {output});
        if (!foreign.isEmpty() && !request.overwrites) {
            throw Error(Text::tr("These files were not made by an output or were changed since: "
                                 "%1. Allow overwriting, or choose another folder")
                            .arg(foreign.join(QStringLiteral(", "))),
                        {});
        }
        const bool isPrintFile = output == Output::PrintPdf || output == Output::PrintTiff;
        status.notes = isPrintFile ? writePrintFiles(result, output, request, progress)
                                   : writeOutput(result, output, request.folder, progress);
        status.files = existingFiles(request.folder, output);
        keepRecord(request.folder, result, status);
        status.state = OutputState::Done;
    } catch (const Error& error) {
        status.state = OutputState::Failed;
        status.reason = error.sentence();
        status.files = existingFiles(request.folder, output);
        status.files.removeIf([&](const QString& file) {
            return before.value(file) != changeOf(request.folder, file);
        });
    }
    return status;
}

} // namespace

std::vector<OutputStatus> outputStates(const QString& folder, const std::vector<Output>& outputs,
                                       const Project& project) {
    const QJsonObject record = recordIn(folder);
    const QString state = stateOf(project);
    std::vector<OutputStatus> states;
    for (const Output output : outputs) {
        states.push_back(stateIn(folder, record, output, state));
    }
    return states;
}

QStringList foreignFiles(const QString& folder, const std::vector<Output>& outputs) {
    const QJsonObject record = recordIn(folder);
    QStringList foreign;
    for (const Output output : outputs) {
        const QJsonObject own = filesIn(record, output);
        for (const QString& file : existingFiles(folder, output)) {
            if (!own.contains(file) ||
                hashOf(QDir(folder).filePath(file)) != own[file].toString()) {
                foreign << file;
            }
        }
    }
    return foreign;
}

void checkOutputsFolder(const QString& folder, const std::vector<Output>& outputs) {
    QStringList files;
    for (const Output output : outputs) {
        files += outputFiles(output);
    }
    FolderTransaction(folder, files);
}

std::vector<OutputStatus> makeOutputs(const JobResult& result, const OutputRequest& request,
                                      const Progress& progress) {
    std::vector<OutputStatus> states;
    const auto count = double(request.outputs.size());
    for (const Output output : request.outputs) {
        const auto done = double(states.size());
        progress.cancelToken.throwIfCancelled();
        states.push_back(
            made(result, output, request, progress.part(done / count, (done + 1) / count)));
    }
    return states;
}

QString statusText(const OutputStatus& status) {
    const QString name = outputText(status.output);
    switch (status.state) {
    case OutputState::Done: {
        const QString line =
            Text::tr("%1: done, %2").arg(name, status.files.join(QStringLiteral(", ")));
        return (QStringList(line) + status.notes).join(QStringLiteral("\n  "));
    }
    case OutputState::Failed:
        return Text::tr("%1: failed. %2").arg(name, status.reason);
    case OutputState::OutOfDate:
        return Text::tr("%1: out of date").arg(name);
    case OutputState::NotMade:
        return Text::tr("%1: not made").arg(name);
    }
    return {};
}

} // namespace dipwright
