#include "cli/PlatesFolder.h"

#include "base/Error.h"
#include "cli/Arguments.h"
#include "disk/FolderTransaction.h"
#include "printing/PrintFile.h"
#include "project/OutputSets.h"
#include "sheet/page/PaperMargins.h"
#include "sheet/prepress/PlateProof.h"
#include "sheet/prepress/PrinterColour.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <algorithm>

namespace dipwright::cli {
namespace {

constexpr std::size_t mostDips = 2;
const QString listFile = QStringLiteral("plates.json");
const QStringList fixedFiles{listFile, QStringLiteral("total-ink.png"),
                             QStringLiteral("composite.png")};

QString prefixOf(std::size_t dip, std::size_t dips) {
    return dips > 1 ? immersionFolder(int(dip) + 1) : QString();
}

QJsonObject listIn(const QString& folder, const QString& prefix) {
    constexpr qint64 mostBytes = 1 << 20;
    QFile file(QDir(folder).filePath(prefix + listFile));
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.read(mostBytes)).object()
                                          : QJsonObject();
}

// The plates of one sheet that an earlier call has written.
struct EarlierPlates {
    QString job;
    QStringList files; // relative to the folder
};

// Returns what the lists in the folder name.
std::vector<EarlierPlates> earlierPlates(const QString& folder) {
    static const QRegularExpression plate(QStringLiteral("^plate-\\d+-[A-Za-z0-9-]*\\.png$"));
    std::vector<EarlierPlates> all;
    for (const QString& prefix : {prefixOf(0, 1), prefixOf(0, mostDips), prefixOf(1, mostDips)}) {
        const QJsonObject list = listIn(folder, prefix);
        if (!list[QStringLiteral("plates")].isArray() || !list.contains(QStringLiteral("job"))) {
            continue;
        }
        EarlierPlates earlier{list[QStringLiteral("job")].toString(), {}};
        for (const QString& name : fixedFiles) {
            earlier.files << prefix + name;
        }
        for (const QJsonValue& one : list[QStringLiteral("plates")].toArray()) {
            const QString name = one[QStringLiteral("file")].toString();
            if (plate.match(name).hasMatch()) {
                earlier.files << prefix + name;
            }
        }
        all.push_back(std::move(earlier));
    }
    return all;
}

// Throws Error if a file that is not among the earlier plates has one of the names.
void refuseOthersFiles(const QString& folder, const QStringList& names,
                       const std::vector<EarlierPlates>& earlier) {
    for (const QString& name : names) {
        const QString path = QDir(folder).filePath(name);
        const bool isEarlier = std::ranges::any_of(
            earlier, [&](const EarlierPlates& plates) { return plates.files.contains(name); });
        if (!isEarlier && QFile::exists(path)) {
            throw Error(QStringLiteral("The plates would replace this file, which is not from "
                                       "earlier plates; choose another folder"),
                        path);
        }
    }
}

} // namespace

void checkPlatesFolder(const QString& folder, const std::vector<std::size_t>& dips,
                       std::size_t count) {
    QStringList names;
    for (const std::size_t dip : dips) {
        for (const QString& name : fixedFiles) {
            names << prefixOf(dip, count) + name;
        }
    }
    refuseOthersFiles(folder, names, earlierPlates(folder));
    FolderTransaction(folder, names);
}

void writePlates(const JobResult& result, const std::vector<std::size_t>& dips,
                 const PrinterColour& colour, const QString& folder, const Progress& progress,
                 QTextStream& out) {
    const std::optional<PrinterProfile>& profile = result.project.profiles.printer;
    const PrintCorrection correction = printCorrection(profile, &colour);
    QStringList names, jobs;
    std::vector<Sheet> sheets;
    for (const ImmersionResult& dip : result.immersions) {
        sheets.push_back(numberedFor(profile, dip.sheet));
        jobs << sheets.back().job.hash;
    }
    std::vector<ProofFile> files;
    for (const std::size_t dip : dips) {
        progress(dip == dips.front() ? 0 : 0.5, QStringLiteral("Making the plates"));
        const Sheet& sheet = sheets[dip];
        SeparationProof proof = separationProof(sheet, correction);
        out << QStringLiteral("%1\n").arg(sheet.job.immersion)
            << figuresTable(proof.figures, sheet.passes);
        for (ProofFile& file : proof.files) {
            file.name = prefixOf(dip, sheets.size()) + file.name;
            names << file.name;
            files.push_back(std::move(file));
        }
    }
    const std::vector<EarlierPlates> earlier = earlierPlates(folder);
    refuseOthersFiles(folder, names, earlier);
    for (const EarlierPlates& plates : earlier) {
        // The other dip of the same job keeps its plates.
        if (!jobs.contains(plates.job) || names.contains(plates.files.front())) {
            names += plates.files;
        }
    }
    names.removeDuplicates();
    FolderTransaction transaction(folder, names);
    for (const ProofFile& file : files) {
        transaction.write(file.name, file.contents);
    }
    transaction.commit();
    out << wrote(folder);
}

} // namespace dipwright::cli
