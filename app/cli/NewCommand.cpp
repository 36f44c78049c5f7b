#include "cli/Arguments.h"
#include "project/CadModel.h"
#include "project/Project.h"
#include "settings/FilmSettings.h"

#include "dip/JigModel.h"
#include "disk/AtomicFile.h"
#include "import/trusted/ImportModel.h"
#include "model/ModelFormats.h"
#include "pipeline/JobSheet.h"
#include "pipeline/ValidateJob.h"
#include "project/NewProject.h"
#include "project/ProjectFile.h"

#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>
#include <iterator>

namespace dipwright::cli {
namespace {

constexpr int mostImmersions = 2;

const QString modelOption = QStringLiteral("model");
const QString textureOption = QStringLiteral("texture");
const QString outsideOption = QStringLiteral("allow-outside");
const QString sizeOption = QStringLiteral("size-mm");
const QString presetOption = QStringLiteral("preset");
const QString immersionOption = QStringLiteral("immersion");
const QString jigOption = QStringLiteral("jig");

// Throws UsageError if a SPEC gives a key twice.
void requireOnce(const QStringList& parts, const QString& where) {
    QStringList keys;
    for (const QString& part : parts) {
        const QString key = part.section(QLatin1Char('='), 0, 0).trimmed();
        if (keys.contains(key)) {
            throw UsageError(QStringLiteral("“%1” is given twice; give it once").arg(key), where);
        }
        keys << key;
    }
}

// Applies one KEY=VALUE of a SPEC to the immersion with this index. `where` names the option.
void applyPart(Project& project, std::size_t index, const QString& part, const QString& where) {
    static const QMap<QString, QString> fields{
        {QStringLiteral("name"), QStringLiteral("name")},
        {QStringLiteral("rotation"), QStringLiteral("rotation_deg")},
        {QStringLiteral("offset"), QStringLiteral("offset_mm")},
        {QStringLiteral("path"), QStringLiteral("path.kind")},
        {QStringLiteral("heading"), QStringLiteral("path.heading_deg")},
        {QStringLiteral("angle"), QStringLiteral("path.angle_deg")},
        {QStringLiteral("level"), QStringLiteral("path.level_depth_mm")},
        {QStringLiteral("radius"), QStringLiteral("path.roll_radius_mm")},
        {QStringLiteral("turn"), QStringLiteral("path.turn_deg")},
        {QStringLiteral("water"), QStringLiteral("path.water_speed_mm_s")},
        {QStringLiteral("keys"), QStringLiteral("path.keys")}};
    const auto equals = part.indexOf(QLatin1Char('='));
    const QString key = part.left(qMax(equals, 0)).trimmed();
    if (!fields.contains(key)) {
        throw UsageError(QStringLiteral("Write a dip as name=Top,rotation=rx;ry;rz,offset=x;z, "
                                        "and its path as path=tilt,angle=20,heading=90"),
                         where);
    }
    setByOption(project, QStringLiteral("immersions[%1].%2").arg(index).arg(fields.value(key)),
                part.mid(equals + 1).trimmed(), where);
}

// Tells whether a path of this kind uses the value of a key of --immersion.
bool isUsed(const QString& key, const DipPath& path) {
    const bool hasAngle = path.kind != PathKind::Straight && path.kind != PathKind::Poses;
    const QMap<QString, bool> uses{
        {QStringLiteral("angle"), hasAngle},
        {QStringLiteral("heading"), hasAngle || path.waterSpeed != DipPath().waterSpeed},
        {QStringLiteral("level"), path.kind == PathKind::Tilt},
        {QStringLiteral("radius"), path.kind == PathKind::Roll},
        {QStringLiteral("turn"), path.kind != PathKind::Poses},
        {QStringLiteral("keys"), path.kind == PathKind::Poses}};
    return uses.value(key, true);
}

// Throws UsageError for a key of --immersion that the path of its dip does not use.
void requireUsedKeys(const Project& project, const QStringList& specs) {
    for (qsizetype index = 0; index < specs.size(); ++index) {
        for (const QString& part : specs[index].split(QLatin1Char(','))) {
            const QString key = part.section(QLatin1Char('='), 0, 0).trimmed();
            if (!isUsed(key, project.immersions[std::size_t(index)].path)) {
                throw UsageError(
                    QStringLiteral("“%1” has no effect on this path; leave it out, or choose "
                                   "another path")
                        .arg(key),
                    QStringLiteral("--immersion %1").arg(specs[index]));
            }
        }
    }
}

void applyImmersions(Project& project, const QStringList& specs) {
    if (specs.size() > mostImmersions) {
        throw UsageError(
            QStringLiteral("A part is dipped once or twice; give --immersion at most twice"),
            QStringLiteral("--immersion"));
    }
    if (specs.isEmpty()) {
        return;
    }
    project.immersions.clear();
    for (const QString& spec : specs) {
        const std::size_t index = project.immersions.size();
        project.immersions.emplace_back().name = QStringLiteral("Dip %1").arg(index + 1);
        const QStringList parts = spec.split(QLatin1Char(','));
        requireOnce(parts, QStringLiteral("--immersion %1").arg(spec));
        for (const QString& part : parts) {
            applyPart(project, index, part, QStringLiteral("--immersion %1").arg(part));
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

void print(const ImportReport& report, const QString& whose, Console& console) {
    for (const QString& repair : report.repairs) {
        console.out() << whose << repair << '\n';
    }
    for (const QString& warning : report.warnings) {
        console.out() << "warning: " << whose << warning << '\n';
    }
}

// Throws UsageError if the tolerance of a CAD model's triangles is set for another model.
void requireCadFor(Millimetres tessellation, bool isCad) {
    asUsage(QStringLiteral("--set model.tessellation_mm"),
            [&] { requireCad(isCad || tessellation == Millimetres(0), {}); });
}

void importInto(Project& project, const QCommandLineParser& parser, Console& console) {
    const QString path = parser.value(modelOption);
    ImportOptions options;
    options.texture = parser.value(textureOption);
    options.allowOutside = parser.isSet(outsideOption);
    if (parser.isSet(sizeOption)) {
        options.longestEdge = Millimetres(numberOption(parser, sizeOption, 0.1, 10'000));
    }
    options.tessellation = project.modelOrigin.tessellation;
    const ImportedModel imported = importModel(path, options, console.progress());
    requireCadFor(options.tessellation, imported.report.cad.has_value());
    print(imported.report, {}, console);
    setModel(project, imported, path, options);
    if (const QString cad = cadText(project); !cad.isEmpty()) {
        console.out() << cad << '\n';
    }
}

struct JigSpec {
    QString path;
    JigPart part; // the jig's part, without its model
    ImportOptions options;
};

// Parses FILE,name=Knob,rotation=rx;ry;rz,offset=x;z,height=y,size=N.
JigSpec jigSpec(const QString& text) {
    static const QRegularExpression next(QStringLiteral(",(?=[a-z_]+=)"));
    static const QStringList keys{QStringLiteral("name"), QStringLiteral("rotation"),
                                  QStringLiteral("offset")};
    const QString where = QStringLiteral("--jig %1").arg(text);
    QStringList words = text.split(next);
    JigSpec spec;
    spec.path = words.takeFirst();
    requireOnce(words, where);
    Project place; // a project used only to parse and check the values of its immersion
    place.immersions.resize(1);
    place.immersions[0].name = QFileInfo(spec.path).completeBaseName();
    for (const QString& word : words) {
        const bool isHeight = word.startsWith(QLatin1String("height="));
        if (keys.contains(word.section(QLatin1Char('='), 0, 0))) {
            applyPart(place, 0, word, where);
            continue;
        }
        if (!isHeight && !word.startsWith(QLatin1String("size="))) {
            throw UsageError(QStringLiteral("“%1” is not known; write a model on a jig as "
                                            "FILE,name=Knob,rotation=rx;ry;rz,offset=x;z,"
                                            "height=y,size=N")
                                 .arg(word),
                             where);
        }
        bool isNumber = false;
        const double value = word.section(QLatin1Char('='), 1).toDouble(&isNumber);
        if (!isNumber || !(value >= (isHeight ? 0 : 0.1) && value <= 10'000)) {
            throw UsageError(
                QStringLiteral("The height must be 0 to 10,000 mm and the size 0.1 to 10,000 mm"),
                where);
        }
        if (isHeight) {
            spec.part.height = Millimetres(value);
        } else {
            spec.options.longestEdge = Millimetres(value);
        }
    }
    spec.part.placed = place.immersions[0];
    return spec;
}

// Returns a field resolution for the whole jig. The smallest part gets as many samples as it would
// have alone, but the resolution is at most `most`.
int jigFieldResolution(int resolution, const std::vector<JigPart>& parts, const TexturedMesh& jig) {
    constexpr int most = 512;
    double smallest = longestEdgeOf(jig.mesh);
    const double whole = smallest;
    for (const JigPart& part : parts) {
        smallest = std::min(smallest, longestEdgeOf(part.model->mesh));
    }
    return int(std::clamp(resolution * whole / smallest, double(resolution), double(most)));
}

void importJig(Project& project, const std::vector<JigSpec>& specs,
               const QCommandLineParser& parser, Console& console) {
    std::vector<JigPart> parts;
    std::transform(specs.begin(), specs.end(), std::back_inserter(parts),
                   [](const JigSpec& spec) { return spec.part; });
    numberEqualNames(parts);
    QStringList remarks, losses;
    bool anyCad = false;
    for (std::size_t i = 0; i < specs.size(); ++i) {
        const JigSpec& spec = specs[i];
        const QString whose = parts[i].placed.name + QStringLiteral(": ");
        ImportOptions options = spec.options;
        options.allowOutside = parser.isSet(outsideOption);
        options.tessellation = project.modelOrigin.tessellation;
        const ImportedModel imported = importModel(spec.path, options, console.progress());
        anyCad = anyCad || imported.report.cad;
        print(imported.report, whose, console);
        const auto keep = [&](const QString& sentences, QStringList& all) {
            if (!sentences.isEmpty()) {
                all.push_back(whose + sentences);
            }
        };
        keep(imported.report.remarks(), remarks);
        keep(imported.report.losses.join(QStringLiteral("; ")), losses);
        parts[i].model = std::make_shared<const TexturedMesh>(imported.model);
    }
    requireCadFor(project.modelOrigin.tessellation, anyCad);
    project.modelOrigin.tessellation = Millimetres(0); // the jig is no CAD model
    project.modelOrigin.remarks = remarks.join(QStringLiteral("; "));
    project.modelOrigin.losses = losses.join(QStringLiteral("; "));
    auto jig = std::make_shared<const TexturedMesh>(jigModel(parts));
    if (project.fieldResolution == Project().fieldResolution) {
        project.fieldResolution = jigFieldResolution(project.fieldResolution, parts, *jig);
    }
    project.model = std::move(jig);
}

// Throws UsageError if the project file would replace a model or picture that it is made from.
void requireOther(const QString& path, const QString& taken) {
    const QString source = QFileInfo(taken).canonicalFilePath();
    if (!source.isEmpty() && source == QFileInfo(path).canonicalFilePath()) {
        throw UsageError(
            QStringLiteral("The project would replace its own source; choose another file"), path);
    }
}

class NewCommand : public Command {
public:
    QString name() const override { return QStringLiteral("new"); }
    QString summary() const override {
        return QStringLiteral("Makes a project from a textured model, which it embeds.");
    }

    void declare(CommandSyntax& syntax) const override {
        syntax.addPositionalArgument(
            QStringLiteral("OUT.dipw"),
            QStringLiteral("The project to write. An existing file is replaced."));
        syntax.addOption({modelOption, QStringLiteral("The model: %1.").arg(modelFormatNames()),
                          QStringLiteral("FILE")});
        syntax.addOption({textureOption,
                          QStringLiteral("A picture that replaces the model's own texture."),
                          QStringLiteral("FILE")});
        syntax.addOption(
            {outsideOption, QStringLiteral("Also reads files outside the model's folder that the "
                                           "model refers to. Without this option such a model is "
                                           "refused.")});
        syntax.addOption({sizeOption,
                          QStringLiteral("Scales the longest edge of the bounding box to N mm. "
                                         "Without it one unit of the file is 1 mm, unless the "
                                         "file states its unit."),
                          QStringLiteral("N")});
        syntax.addOption(
            {presetOption,
             QStringLiteral(
                 "The preset for film and process: production (the default) or paper-2020."),
             QStringLiteral("NAME"), QStringLiteral("production")});
        syntax.addOption(
            {immersionOption,
             QStringLiteral(
                 "One dip: name=Top,rotation=rx;ry;rz,offset=x;z. The rotation is in degrees about "
                 "X, Y and Z in this order; the offset is in mm on the water. A path is "
                 "path=slanted|tilt|roll|poses with heading, angle, level, radius, turn, water "
                 "and keys, in degrees, mm and mm/s (path.heading_deg, .angle_deg, "
                 ".level_depth_mm, .roll_radius_mm, .turn_deg, .water_speed_mm_s and .keys of the "
                 "project). Give it once or twice. Without it the model is dipped once, without "
                 "rotation."),
             QStringLiteral("SPEC")});
        syntax.addOption(
            {jigOption,
             QStringLiteral(
                 "Instead of --model, once for each model: dips several models together on one "
                 "jig. FILE,name=Knob,rotation=rx;ry;rz,offset=x;z,height=y,size=N. The offset "
                 "refers to the model's middle, the height to its lowest point and the size to its "
                 "longest edge, all in mm. Offsets count relative to the other models: the jig's "
                 "middle lies in the film's middle, unless --immersion moves it."),
             QStringLiteral("FILE")});
        declareSettings(syntax, true);
    }

    void run(const QCommandLineParser& parser, Console& console) const override {
        const QString path = positionalArgument(parser, QStringLiteral("OUT.dipw"));
        std::vector<JigSpec> jig;
        for (const QString& text : parser.values(jigOption)) {
            jig.push_back(jigSpec(text));
            requireOther(path, jig.back().path);
        }
        if (parser.value(modelOption).isEmpty() == jig.empty()) {
            throw UsageError(
                QStringLiteral(
                    "Name the model with --model FILE, or each model on a jig with --jig FILE"),
                QStringLiteral("--model"));
        }
        if (!jig.empty() && (parser.isSet(textureOption) || parser.isSet(sizeOption))) {
            throw UsageError(
                QStringLiteral(
                    "--texture and --size-mm do not apply to a jig; give each model its own size"),
                QStringLiteral("--jig"));
        }
        requireOther(path, parser.value(modelOption));
        requireOther(path, parser.value(textureOption));
        const auto isZip = [](const QByteArray& begin) { return begin.startsWith("PK"); };
        requireReplaceable(path, isZip, QStringLiteral("a project"));
        ProjectFile file(path);
        checkWritable(path); // fails now instead of after the import
        Project project = newProject(path);
        applyPresetOption(project, parser.value(presetOption));
        applyImmersions(project, parser.values(immersionOption));
        applySettings(project, parser);
        requireUsedKeys(project, parser.values(immersionOption));
        checkSpots(project);
        if (jig.empty()) {
            importInto(project, parser, console);
        } else {
            importJig(project, jig, parser, console);
        }
        for (const Immersion& immersion : project.immersions) {
            requirePath(project, immersion);
            if (const QString fault = misplacement(project, immersion); !fault.isEmpty()) {
                console.out() << "warning: " << immersion.name << ": " << fault << '\n';
            }
        }
        file.save(project);
        console.out() << wrote(path);
    }
};

} // namespace

std::unique_ptr<Command> newCommand() {
    return std::make_unique<NewCommand>();
}

} // namespace dipwright::cli
