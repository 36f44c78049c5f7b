#include "project/OutputSets.h"

#include "base/Error.h"
#include "base/JsonText.h"
#include "project/Project.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>

#include <algorithm>
#include <optional>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(OutputSets)
};

const QString entry = QStringLiteral("outputs.json");
const QString setsKey = QStringLiteral("sets");
const QString nameKey = QStringLiteral("name");
const QString outputsKey = QStringLiteral("outputs");
constexpr int mostDips = 2;

std::optional<Output> outputOf(const QString& word) {
    const auto found = std::find_if(allOutputs.begin(), allOutputs.end(),
                                    [&](Output output) { return outputWord(output) == word; });
    return found == allOutputs.end() ? std::nullopt : std::optional<Output>(*found);
}

// Returns the outputs that the words name, in the order of allOutputs.
std::vector<Output> outputsOf(const QStringList& words) {
    std::vector<Output> outputs;
    std::copy_if(allOutputs.begin(), allOutputs.end(), std::back_inserter(outputs),
                 [&](Output output) { return words.contains(outputWord(output)); });
    return outputs;
}

// Returns the names with %1 replaced by the number of each dip.
QStringList ofEachDip(const QStringList& names) {
    QStringList files;
    for (int dip = 1; dip <= mostDips; ++dip) {
        for (const QString& name : names) {
            files << name.arg(dip);
        }
    }
    return files;
}

QJsonArray setsIn(const QByteArray& bytes) {
    try {
        requireJsonWithinLimits(bytes, entry);
        return QJsonDocument::fromJson(bytes).object()[setsKey].toArray();
    } catch (const Error&) {
        return {};
    }
}

} // namespace

QString outputWord(Output output) {
    static const QStringList words{
        QStringLiteral("sheet_pdf"),  QStringLiteral("sheet_png"), QStringLiteral("print_pdf"),
        QStringLiteral("print_tiff"), QStringLiteral("proof"),     QStringLiteral("shared_proof"),
        QStringLiteral("traveller"),  QStringLiteral("motion"),    QStringLiteral("cradles"),
        QStringLiteral("report"),     QStringLiteral("film"),      QStringLiteral("maps")};
    return words.at(int(output));
}

QString outputText(Output output) {
    switch (output) {
    case Output::SheetPdf:
        return Text::tr("Sheets as PDF");
    case Output::SheetPng:
        return Text::tr("Film images as PNG");
    case Output::PrintPdf:
        return Text::tr("Sheets in the printer's colours as PDF");
    case Output::PrintTiff:
        return Text::tr("Sheets in the printer's colours as TIFF");
    case Output::Proof:
        return Text::tr("Proof");
    case Output::SharedProof:
        return Text::tr("Proof to share");
    case Output::Traveller:
        return Text::tr("Traveller");
    case Output::Motion:
        return Text::tr("Motion programs");
    case Output::Cradles:
        return Text::tr("Cradles");
    case Output::Report:
        return Text::tr("Report");
    case Output::Film:
        return Text::tr("Film and part for ParaView");
    case Output::Maps:
        return Text::tr("Maps of the film");
    }
    return {};
}

QString immersionFolder(int number) {
    return QStringLiteral("immersion-%1/").arg(number);
}

QStringList outputFiles(Output output) {
    const auto inFolders = [](const QStringList& names) {
        QStringList files;
        for (int dip = 1; dip <= mostDips; ++dip) {
            for (const QString& name : names) {
                files << immersionFolder(dip) + name;
            }
        }
        return files;
    };
    switch (output) {
    case Output::SheetPdf:
        return inFolders({QStringLiteral("sheet.pdf")});
    case Output::SheetPng:
        return inFolders({QStringLiteral("sheet.png")});
    case Output::PrintPdf:
        return inFolders({QStringLiteral("print.pdf")});
    case Output::PrintTiff:
        return inFolders({QStringLiteral("print.tiff")});
    case Output::Proof:
        return {QStringLiteral("proof.png"), QStringLiteral("proof-without-white.png"),
                QStringLiteral("coverage.png")};
    case Output::SharedProof:
        return {QStringLiteral("proof.html"), QStringLiteral("proof.glb")};
    case Output::Traveller:
        return {QStringLiteral("traveller.pdf")};
    case Output::Motion:
        return ofEachDip({QStringLiteral("motion-%1.csv"), QStringLiteral("motion-%1.gcode")});
    case Output::Cradles:
        return ofEachDip({QStringLiteral("cradle-%1.stl"), QStringLiteral("cradle-%1.3mf")});
    case Output::Report:
        return {QStringLiteral("report.json")};
    case Output::Film:
        return inFolders({QStringLiteral("film.vtp"), QStringLiteral("body.vtp")});
    case Output::Maps:
        return inFolders({QStringLiteral("stretch.png"), QStringLiteral("wrinkling.png"),
                          QStringLiteral("certainty.png"), QStringLiteral("tolerance.png")});
    }
    return {};
}

std::vector<OutputSet> builtInOutputSets() {
    return {{QStringLiteral("Everything"), {allOutputs.begin(), allOutputs.end()}},
            {QStringLiteral("Print shop"), {Output::PrintPdf, Output::PrintTiff, Output::Proof}},
            {QStringLiteral("Tank"), {Output::Traveller, Output::Motion, Output::Cradles}},
            {QStringLiteral("Customer"), {Output::SharedProof}}};
}

QString outputSetText(const QString& name) {
    return name == QLatin1String("Everything")   ? Text::tr("Everything")
           : name == QLatin1String("Print shop") ? Text::tr("Print shop")
           : name == QLatin1String("Tank")       ? Text::tr("Tank")
           : name == QLatin1String("Customer")   ? Text::tr("Customer")
                                                 : name;
}

std::vector<OutputSet> ownOutputSets(const Project& project) {
    std::vector<OutputSet> sets;
    const auto kept = project.unknownEntries.find(entry);
    if (kept == project.unknownEntries.end()) {
        return sets;
    }
    for (const QJsonValue& json : setsIn(kept->second)) {
        const QString name = json[nameKey].toString().simplified().left(longestOutputSetName);
        const std::vector<Output> outputs = outputsOf(json[outputsKey].toVariant().toStringList());
        if (!name.isEmpty() && !outputs.empty() && sets.size() < mostOutputSets) {
            sets.push_back({name, outputs});
        }
    }
    return sets;
}

std::vector<OutputSet> outputSets(const Project& project) {
    std::vector<OutputSet> sets = ownOutputSets(project);
    for (const OutputSet& builtIn : builtInOutputSets()) {
        if (std::none_of(sets.begin(), sets.end(), [&](const OutputSet& set) {
                return set.name.compare(builtIn.name, Qt::CaseInsensitive) == 0;
            })) {
            sets.push_back(builtIn);
        }
    }
    return sets;
}

Project withOutputSets(Project project, const std::vector<OutputSet>& own) {
    QJsonArray sets;
    for (const OutputSet& set : own) {
        QJsonArray words;
        for (const Output output : set.outputs) {
            words.append(outputWord(output));
        }
        if (std::size_t(sets.size()) < mostOutputSets) {
            sets.append(QJsonObject{{nameKey, set.name}, {outputsKey, words}});
        }
    }
    project.unknownEntries.erase(entry);
    if (!sets.isEmpty()) {
        project.unknownEntries[entry] = QJsonDocument(QJsonObject{{setsKey, sets}}).toJson();
    }
    return project;
}

std::vector<Output> outputsNamed(const Project& project, const QString& name) {
    QStringList names, words;
    for (const OutputSet& set : outputSets(project)) {
        if (set.name.compare(name, Qt::CaseInsensitive) == 0) {
            return set.outputs;
        }
        names << QStringLiteral("“%1”").arg(set.name);
    }
    for (const Output output : allOutputs) {
        words << outputWord(output);
    }
    const QStringList wanted = name.split(u',');
    for (const QString& word : wanted) {
        if (!outputOf(word)) {
            throw Error(Text::tr("There is no output set of this name; the project has %1. A list "
                                 "of outputs is also possible: %2")
                            .arg(names.join(QStringLiteral(", ")), words.join(u',')),
                        name);
        }
    }
    return outputsOf(wanted);
}

} // namespace dipwright
