// Output sets: named lists of the files to make from a job's result. A project keeps its own sets
// in its file beside project.json, as the entry outputs.json. They are not part of the job number.
#pragma once

#include <QString>
#include <array>
#include <vector>

namespace dipwright {

struct Project;

// One kind of file, made for each dip or once for the job.
enum class Output {
    SheetPdf,    // sheet at true size, in sRGB
    SheetPng,    // film image
    PrintPdf,    // sheet in the scale and colours of the project's printer profile
    PrintTiff,   // the same as TIFF
    Proof,       // pictures of the printed part and of the coverage
    SharedProof, // the printed part as a model and as a page to turn it
    Traveller,
    Motion,
    Cradles,
    Report,
    Film, // film and body for ParaView
    Maps  // maps of stretch, wrinkling, numerical error and tolerances
};
inline constexpr std::array allOutputs{Output::SheetPdf,  Output::SheetPng, Output::PrintPdf,
                                       Output::PrintTiff, Output::Proof,    Output::SharedProof,
                                       Output::Traveller, Output::Motion,   Output::Cradles,
                                       Output::Report,    Output::Film,     Output::Maps};

// The word for an output in files and on the command line, such as "sheet_pdf".
QString outputWord(Output output);
// The name of an output for the user.
QString outputText(Output output);
// The folder of a dip's files, relative to the folder of the results, with a slash at its end. The
// first dip has the number 1.
QString immersionFolder(int number);
// The names, relative to the folder, of all files that an output may consist of.
QStringList outputFiles(Output output);

struct OutputSet {
    QString name;
    std::vector<Output> outputs; // in the order of allOutputs
    bool operator==(const OutputSet&) const = default;
};

inline constexpr std::size_t mostOutputSets = 50;
inline constexpr int longestOutputSetName = 100;

// Returns the sets that every project has: "Everything", "Print shop", "Tank" and "Customer".
std::vector<OutputSet> builtInOutputSets();
// The name of a built-in set in the user's language; other names unchanged.
QString outputSetText(const QString& name);
// Returns the project's own sets. Skips what is not a set.
std::vector<OutputSet> ownOutputSets(const Project& project);
// Returns the project's own sets, then the built-in sets whose names it does not use.
std::vector<OutputSet> outputSets(const Project& project);
// Replaces the project's own sets. Keeps the first mostOutputSets.
Project withOutputSets(Project project, const std::vector<OutputSet>& own);
// Returns the outputs of the set with this name (upper and lower case are equal), or of a list of
// words separated by commas. Throws Error, which lists the names, if there is none.
std::vector<Output> outputsNamed(const Project& project, const QString& name);

} // namespace dipwright
