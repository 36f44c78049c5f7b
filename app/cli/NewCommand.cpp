#include "cli/Arguments.h"

#include "disk/WholeFile.h"
#include "import/ImportModel.h"
#include "model/ModelFormats.h"
#include "project/ProjectFile.h"

#include <QDate>
#include <QFileInfo>

namespace dipwright::cli {
namespace {

constexpr int mostImmersions = 2;

const QString modelOption = QStringLiteral("model");
const QString textureOption = QStringLiteral("texture");
const QString outsideOption = QStringLiteral("allow-outside");
const QString sizeOption = QStringLiteral("size-mm");
const QString presetOption = QStringLiteral("preset");
const QString immersionOption = QStringLiteral("immersion");

// One KEY=VALUE of a SPEC into the immersion of that index.
void applyPart(Project& project, std::size_t index, const QString& part) {
    static const QMap<QString, QString> fields{
        {QStringLiteral("name"), QStringLiteral("name")},
        {QStringLiteral("rotation"), QStringLiteral("rotation_deg")},
        {QStringLiteral("offset"), QStringLiteral("offset_mm")}};
    const auto equals = part.indexOf(QLatin1Char('='));
    const QString key = part.left(qMax(equals, 0)).trimmed();
    if (!fields.contains(key)) {
        throw UsageError(QStringLiteral("An immersion is written "
                                        "name=Top,rotation=rx;ry;rz,offset=x;z"),
                         QStringLiteral("--immersion %1").arg(part));
    }
    setByOption(project, QStringLiteral("immersions[%1].%2").arg(index).arg(fields.value(key)),
                part.mid(equals + 1).trimmed(), QStringLiteral("--immersion %1").arg(part));
}

void applyImmersions(Project& project, const QStringList& specs) {
    if (specs.size() > mostImmersions) {
        throw UsageError(QStringLiteral("A body is dipped once or twice, give one or two"),
                         QStringLiteral("--immersion"));
    }
    if (specs.isEmpty()) {
        return;
    }
    project.immersions.clear();
    for (const QString& spec : specs) {
        const std::size_t index = project.immersions.size();
        project.immersions.emplace_back().name = QStringLiteral("Immersion %1").arg(index + 1);
        for (const QString& part : spec.split(QLatin1Char(','))) {
            applyPart(project, index, part);
        }
    }
}

void applyPresetOption(Project& project, const QString& preset) {
    try {
        applyPreset(project, preset);
    } catch (const Error& error) {
        throw UsageError(error.message(), QStringLiteral("--preset"));
    }
}

void importInto(Project& project, const QCommandLineParser& parser, Console& console) {
    const QString path = parser.value(modelOption);
    ImportOptions options;
    options.texture = parser.value(textureOption);
    options.allowOutside = parser.isSet(outsideOption);
    if (parser.isSet(sizeOption)) {
        options.longestEdge = Millimetres(numberOption(parser, sizeOption, 0.1, 10'000));
    }
    const ImportedModel imported = importModel(path, options, console.progress());
    for (const QString& line : imported.report.repairs + imported.report.warnings) {
        console.out() << line << '\n';
    }
    project.model = std::make_shared<const TexturedMesh>(imported.model);
    project.modelOrigin.source = path;
    project.modelOrigin.texture = options.texture;
}

// A model or picture that the project takes in is not replaced by it.
void requireOther(const QString& path, const QCommandLineParser& parser, const QString& option) {
    const QString source = QFileInfo(parser.value(option)).canonicalFilePath();
    if (!source.isEmpty() && source == QFileInfo(path).canonicalFilePath()) {
        throw UsageError(QStringLiteral("The project would replace its own source, name another "
                                        "file"),
                         path);
    }
}

class NewCommand : public Command {
public:
    QString name() const override { return QStringLiteral("new"); }
    QString summary() const override {
        return QStringLiteral("Makes a project of a textured model, which it embeds.");
    }

    void declare(CommandSyntax& syntax) const override {
        syntax.addPositionalArgument(
            QStringLiteral("OUT.dipw"),
            QStringLiteral("The project to write. A file of that name is replaced."));
        syntax.addOption({modelOption, QStringLiteral("The model: %1.").arg(modelFormatNames()),
                          QStringLiteral("FILE")});
        syntax.addOption({textureOption, QStringLiteral("A picture in place of the model's own."),
                          QStringLiteral("FILE")});
        syntax.addOption(
            {outsideOption, QStringLiteral("Reads files that the model names outside its folder, "
                                           "too. Without it such a model is refused.")});
        syntax.addOption({sizeOption,
                          QStringLiteral("Scales the longest edge of the bounding box to N mm. "
                                         "Without it one unit of the file is one millimetre."),
                          QStringLiteral("N")});
        syntax.addOption({presetOption, QStringLiteral("production (the default) or paper-2020."),
                          QStringLiteral("NAME"), QStringLiteral("production")});
        syntax.addOption(
            {immersionOption,
             QStringLiteral("One dip: name=Top,rotation=rx;ry;rz,offset=x;z, degrees about X, Y, Z "
                            "in that order and millimetres on the water. Give one or two; without "
                            "it the model is dipped once, as it stands."),
             QStringLiteral("SPEC")});
        declareSettings(syntax);
    }

    void run(const QCommandLineParser& parser, Console& console) const override {
        const QString path = positionalArgument(parser, QStringLiteral("OUT.dipw"));
        if (parser.value(modelOption).isEmpty()) {
            throw UsageError(QStringLiteral("Name the model with --model FILE"),
                             QStringLiteral("--model"));
        }
        requireOther(path, parser, modelOption);
        requireOther(path, parser, textureOption);
        ProjectFile file(path);
        checkWritable(path); // better now than after the work
        Project project;
        project.name = projectName(path);
        project.date = QDate::currentDate().toString(Qt::ISODate);
        project.film.resolution = FilmResolution::Automatic;
        applyPresetOption(project, parser.value(presetOption));
        applyImmersions(project, parser.values(immersionOption));
        applySettings(project, parser);
        importInto(project, parser, console);
        file.save(project);
        console.out() << QStringLiteral("Wrote %1\n").arg(path);
    }
};

} // namespace

std::unique_ptr<Command> newCommand() {
    return std::make_unique<NewCommand>();
}

} // namespace dipwright::cli
