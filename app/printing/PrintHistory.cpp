#include "printing/PrintHistory.h"

#include "base/Error.h"
#include "disk/AtomicFile.h"
#include "disk/SmallFile.h"
#include "project/Project.h"
#include "sheet/page/Sheet.h"

#include <QCoreApplication>
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <QUuid>
#include <algorithm>
#include <array>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Printing)
};

const char* const chosenFolder = "DIPWRIGHT_PRINT_HISTORY";
const QString format = QStringLiteral("dipwright-print");
constexpr int version = 1;
constexpr qint64 mostBytes = 64 << 10; // size limit of a record, bytes
constexpr int mostCopies = 100'000;
constexpr double largestMedium = 100'000; // mm, per side

// The words for PrintOutcome in a record, in the order of the enumeration.
constexpr std::array outcomeWords{"sent",      "printed", "handed_over", "written",
                                  "cancelled", "failed",  "stopped",     "unknown"};

// Returns the files of the records, oldest first. Their names sort by time.
QStringList files(const QDir& folder) {
    return folder.entryList({QStringLiteral("*.print.json")}, QDir::Files, QDir::Name);
}

QJsonObject toJson(const PrintRecord& record) {
    return {
        {QStringLiteral("format"), format},
        {QStringLiteral("version"), version},
        {QStringLiteral("when"), record.when.toUTC().toString(Qt::ISODateWithMs)},
        {QStringLiteral("job"), record.job},
        {QStringLiteral("project"), record.project},
        {QStringLiteral("immersion"), record.immersion},
        {QStringLiteral("project_file"), record.source.projectFile},
        {QStringLiteral("film"), record.source.film},
        {QStringLiteral("printer"), record.printer},
        {QStringLiteral("file"), record.file},
        {QStringLiteral("profile"), record.profile},
        {QStringLiteral("medium"), record.mediumName},
        {QStringLiteral("medium_mm"),
         QJsonArray{record.mediumSize.width(), record.mediumSize.height()}},
        {QStringLiteral("copies"), record.copies},
        {QStringLiteral("fate"), QLatin1String(outcomeWords[std::size_t(record.fate)])},
        {QStringLiteral("reason"), record.reason},
    };
}

// Returns the value of `key` as one line without control characters; any program may have written
// it.
QString line(const QJsonObject& json, const char* key) {
    constexpr int longest = 4096;
    return json.value(QLatin1String(key)).toString().left(longest).simplified();
}

std::optional<PrintRecord> recordFromJson(const QJsonObject& json, const QString& id) {
    const auto fate = std::find(outcomeWords.begin(), outcomeWords.end(),
                                json.value(QLatin1String("fate")).toString().toStdString());
    const QDateTime when = QDateTime::fromString(line(json, "when"), Qt::ISODateWithMs);
    if (json.value(QLatin1String("format")) != format ||
        json.value(QLatin1String("version")) != version || fate == outcomeWords.end() ||
        !when.isValid()) {
        return std::nullopt;
    }
    const QJsonArray size = json.value(QLatin1String("medium_mm")).toArray();
    const auto side = [&size](int i) { return std::clamp(size[i].toDouble(), 0.0, largestMedium); };
    return PrintRecord{id,
                       when.toLocalTime(),
                       line(json, "job"),
                       line(json, "project"),
                       line(json, "immersion"),
                       {line(json, "project_file"), line(json, "film")},
                       line(json, "printer"),
                       line(json, "file"),
                       line(json, "profile"),
                       line(json, "medium"),
                       {side(0), side(1)},
                       std::clamp(json.value(QLatin1String("copies")).toInt(1), 1, mostCopies),
                       PrintOutcome(fate - outcomeWords.begin()),
                       line(json, "reason")};
}

} // namespace

PrintSource printSource(const Project& project, const QString& projectFile) {
    PrintSource source;
    if (!projectFile.isEmpty()) {
        source.projectFile = QFileInfo(projectFile).absoluteFilePath();
    }
    if (const auto& film = project.profiles.film) {
        source.film =
            film->lot.isEmpty() ? film->name : Text::tr("%1, lot %2").arg(film->name, film->lot);
    }
    return source;
}

PrintRecord recordOf(const Sheet& sheet, const PrintSource& source,
                     const std::optional<PrinterProfile>& profile, QSizeF mediumSize) {
    PrintRecord record;
    record.job = sheet.job.hash;
    record.project = sheet.job.project;
    record.immersion = sheet.job.immersion;
    record.source = source;
    record.profile = profile ? profile->name : QString();
    record.mediumSize = mediumSize;
    return record;
}

QString outcomeText(const PrintRecord& record) {
    switch (record.fate) {
    case PrintOutcome::Sent:
        return Text::tr("Sent, outcome unknown");
    case PrintOutcome::Printed:
        return Text::tr("Printed");
    case PrintOutcome::HandedOver:
        return Text::tr("Handed to the printer's queue");
    case PrintOutcome::WrittenToFile:
        return Text::tr("Written to a file");
    case PrintOutcome::Cancelled:
        return Text::tr("Cancelled");
    case PrintOutcome::Failed:
        return Text::tr("Failed: %1").arg(record.reason);
    case PrintOutcome::Stopped:
        return Text::tr("Stopped: %1").arg(record.reason);
    case PrintOutcome::Unknown:
        break;
    }
    return Text::tr("Unknown: %1").arg(record.reason);
}

QString historyErrorText(const QString& reason) {
    return Text::tr("This print could not be added to the print history: %1").arg(reason);
}

QString PrintHistory::standardFolder() {
    return qEnvironmentVariableIsEmpty(chosenFolder)
               ? QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
                     QStringLiteral("/prints")
               : qEnvironmentVariable(chosenFolder);
}

PrintHistory::PrintHistory(const QString& folder) : folder_(folder) {}

std::vector<PrintRecord> PrintHistory::records() const {
    const QDir folder(folder_);
    QStringList names = files(folder);
    std::vector<PrintRecord> found;
    for (auto name = names.crbegin(); name != names.crend() && int(found.size()) < mostRecords;
         ++name) {
        try {
            const QByteArray bytes = readSmallFile(folder.filePath(*name), mostBytes);
            const auto record = recordFromJson(QJsonDocument::fromJson(bytes).object(), *name);
            if (record) {
                found.push_back(*record);
            }
        } catch (const Error&) {
            continue; // one damaged file must not hide the others
        }
    }
    return found;
}

QString PrintHistory::keep(PrintRecord& record) const {
    const QDir folder(folder_);
    if (!folder.mkpath(QStringLiteral("."))) {
        return Text::tr("the folder %1 cannot be created").arg(QDir::toNativeSeparators(folder_));
    }
    if (record.id.isEmpty()) {
        record.when = QDateTime::currentDateTimeUtc();
        record.id = QStringLiteral("%1-%2.print.json")
                        .arg(record.when.toString(QStringLiteral("yyyyMMdd'T'HHmmsszzz")),
                             QUuid::createUuid().toString(QUuid::Id128).left(8));
        const QStringList names = files(folder);
        for (qsizetype i = 0; i <= names.size() - mostRecords; ++i) {
            QFile::remove(folder.filePath(names[i]));
        }
    }
    return replaceFile(folder.filePath(record.id), QJsonDocument(toJson(record)).toJson());
}

} // namespace dipwright
