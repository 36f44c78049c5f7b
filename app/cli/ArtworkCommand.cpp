#include "artwork/EditArtwork.h"
#include "cli/Arguments.h"
#include "import/trusted/ReadPictures.h"
#include "pipeline/JobSheet.h"
#include "project/Project.h"
#include "project/ProjectFile.h"
#include "project/ProjectStore.h"
#include "settings/Artwork.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <map>

namespace dipwright::cli {
namespace {

const QString setOption = QStringLiteral("set");
const QString onOption = QStringLiteral("on");
const QString jsonOption = QStringLiteral("json");

const std::map<QString, LayerKind> kinds{{QStringLiteral("picture"), LayerKind::Picture},
                                         {QStringLiteral("text"), LayerKind::Text},
                                         {QStringLiteral("carbon"), LayerKind::Carbon},
                                         {QStringLiteral("camouflage"), LayerKind::Camouflage},
                                         {QStringLiteral("wood"), LayerKind::Wood}};

// Reads a layer's number, counted from 1, and returns its index.
std::size_t takeLayer(Words& words, const Artwork& artwork) {
    const QString word = words.take(QStringLiteral("N"));
    bool isNumber = false;
    const uint number = word.toUInt(&isNumber);
    if (!isNumber || number < 1 || number > artwork.layers.size()) {
        throw UsageError(QStringLiteral("There is no such layer; the project has %1 layers")
                             .arg(artwork.layers.size()),
                         word);
    }
    return number - 1;
}

void applyToLayer(Project& project, std::size_t layer, const QCommandLineParser& parser) {
    for (const QString& setting : parser.values(setOption)) {
        const QString where = QStringLiteral("--set %1").arg(setting);
        const auto equals = setting.indexOf(QLatin1Char('='));
        if (equals <= 0) {
            throw UsageError(
                QStringLiteral("Write a setting as KEY=VALUE, for example size_mm=40;20"), where);
        }
        try {
            setByPath(project,
                      QStringLiteral("artwork.layers[%1].%2").arg(layer).arg(setting.left(equals)),
                      setting.mid(equals + 1));
        } catch (const Error& error) {
            throw UsageError(error.message(), where);
        }
    }
}

// Changes a layer. With another placement it moves as in the window, unless its place is stated.
void change(Project& project, std::size_t layer, const QCommandLineParser& parser) {
    const ArtworkLayer before = project.artwork.layers[layer];
    applyToLayer(project, layer, parser);
    ArtworkLayer& after = project.artwork.layers[layer];
    after.place = replacedAs(after.placement, *project.model, before).place;
    applyToLayer(project, layer, parser);
}

// Returns what a layer is and where it lies; `layer` is as in the project file.
QStringList layerDetails(const QJsonObject& layer) {
    const auto text = [&](const char* key) { return layer.value(QLatin1String(key)).toString(); };
    const auto number = [&](const char* key) { return layer.value(QLatin1String(key)).toDouble(); };
    const bool hasAxis = text("placement") == QLatin1String("plane") ||
                         text("placement") == QLatin1String("cylinder");
    QStringList details{
        text("kind"),
        hasAxis ? QStringLiteral("%1 along %2").arg(text("placement"), text("axis").toUpper())
                : text("placement")};
    if (const double repeat = number("repeat_mm"); repeat > 0) {
        details << QStringLiteral("every %1 mm").arg(repeat);
    } else {
        const QJsonArray size = layer.value(QLatin1String("size_mm")).toArray();
        details << QStringLiteral("within %1 × %2 mm")
                       .arg(size.at(0).toDouble())
                       .arg(size.at(1).toDouble());
    }
    if (const double turn = number("turn_deg"); turn != 0) {
        details << QStringLiteral("turned by %1°").arg(turn);
    }
    if (const double opacity = number("opacity"); opacity < 1) {
        details << QStringLiteral("opacity %1 %").arg(100 * opacity);
    }
    if (!layer.value(QLatin1String("visible")).toBool()) {
        details << QStringLiteral("hidden");
    }
    if (!text("spot").isEmpty()) {
        details << QStringLiteral("spot colour “%1”").arg(text("spot"));
    }
    if (!text("material").isEmpty()) {
        details << QStringLiteral("only on “%1”").arg(text("material"));
    }
    return details;
}

void list(const Project& project, const QCommandLineParser& parser, QTextStream& out) {
    const QJsonObject json = toJson(project).value(QLatin1String("artwork")).toObject();
    if (parser.isSet(jsonOption)) {
        out << QJsonDocument(json).toJson();
        return;
    }
    const QJsonValue base = json.value(QLatin1String("base_colour"));
    out << QStringLiteral("base  %1\n")
               .arg(base.isString() ? base.toString()
                                    : QStringLiteral("the model's own appearance"));
    const QJsonArray layers = json.value(QLatin1String("layers")).toArray();
    for (int index = 0; index < layers.size(); ++index) {
        const QJsonObject layer = layers.at(index).toObject();
        out << QStringLiteral("%1  %2  %3\n")
                   .arg(index + 1, 4)
                   .arg(layer.value(QLatin1String("name")).toString(),
                        layerDetails(layer).join(QStringLiteral(", ")));
    }
}

void add(Project& project, Words& words, const QCommandLineParser& parser, QTextStream& out) {
    const QString word = words.take(QStringLiteral("The kind of layer"));
    const auto kind = kinds.find(word);
    if (kind == kinds.end()) {
        throw UsageError(
            QStringLiteral(
                "There is no such kind of layer; use picture, text, carbon, camouflage or wood"),
            word);
    }
    ArtworkLayer layer = newLayer(kind->second, word);
    if (layer.kind == LayerKind::Picture) {
        const QString file = words.take(QStringLiteral("FILE"));
        layer.picture = artworkPicture(readPictureFile(file));
        layer.name = QFileInfo(file).completeBaseName().left(longestLayerName);
    } else if (layer.kind == LayerKind::Text) {
        layer.text = words.take(QStringLiteral("TEXT")).left(longestLayerText);
        if (layer.text.trimmed().isEmpty()) {
            throw UsageError(QStringLiteral("The text is blank; give the words to print"),
                             QStringLiteral("text"));
        }
        layer.name = layer.text.simplified().left(longestLayerName);
    }
    words.finish();
    addLayer(project.artwork, layer, *project.model);
    const std::size_t index = project.artwork.layers.size() - 1;
    ArtworkLayer& added = project.artwork.layers.back();
    applyToLayer(project, index, parser); // the placement decides where a layer begins
    added = placedOn(*project.model, added);
    if (const QString face = parser.value(onOption); !face.isEmpty()) {
        added = movedOnto(*project.model, added, face);
    }
    applyToLayer(project, index, parser); // a stated place or size replaces that of placedOn()
    out << QStringLiteral("Added %1 as layer %2\n").arg(added.name).arg(index + 1);
    QStringList notes = cutOffWarnings({.base = {}, .layers = {added}}, project.model->mesh);
    if (const QString note = colourNoteOf(added); !note.isEmpty()) {
        notes.append(note);
    }
    printWarnings(notes, out);
}

void move(Artwork& artwork, Words& words, QTextStream& out) {
    const std::size_t from = takeLayer(words, artwork), to = takeLayer(words, artwork);
    words.finish();
    const ArtworkLayer layer = artwork.layers[from];
    artwork.layers.erase(artwork.layers.begin() + std::ptrdiff_t(from));
    artwork.layers.insert(artwork.layers.begin() + std::ptrdiff_t(to), layer);
    out << QStringLiteral("%1 is now layer %2\n").arg(layer.name).arg(to + 1);
}

void remove(Artwork& artwork, Words& words, QTextStream& out) {
    const std::size_t index = takeLayer(words, artwork);
    words.finish();
    out << QStringLiteral("Removed %1\n").arg(artwork.layers[index].name);
    artwork.layers.erase(artwork.layers.begin() + std::ptrdiff_t(index));
    artwork.base = artwork.layers.empty() ? std::nullopt : artwork.base;
}

void setBase(Project& project, Words& words, QTextStream& out) {
    const QString colour = words.take(QStringLiteral("COLOUR"));
    words.finish();
    try {
        setByPath(project, QStringLiteral("artwork.base_colour"),
                  colour == QLatin1String("own") ? QStringLiteral("null") : colour);
    } catch (const Error& error) {
        throw UsageError(error.message(), colour);
    }
    out << QStringLiteral("The base colour is now %1\n")
               .arg(project.artwork.base ? project.artwork.base->name()
                                         : QStringLiteral("the model's own appearance"));
}

class ArtworkCommand : public Command {
public:
    QString name() const override { return QStringLiteral("artwork"); }
    QString summary() const override {
        return QStringLiteral("Puts pictures, text and patterns on a project's part.");
    }

    void declare(CommandSyntax& syntax) const override {
        syntax.addPositionalArgument(
            QStringLiteral("list JOB.dipw | add JOB.dipw picture FILE | add JOB.dipw text TEXT | "
                           "add JOB.dipw carbon|camouflage|wood | set JOB.dipw N | "
                           "move JOB.dipw N TO | remove JOB.dipw N | base JOB.dipw COLOUR|own"),
            QStringLiteral(
                "The action. Layers are numbered from 1, the lowest. A new layer goes on top, in "
                "the middle of the part's front. `base` sets what lies below all layers: a colour, "
                "for example #ffffff, which prints no ink, or `own`, the model's own appearance."),
            QStringLiteral("ACTION"));
        syntax.addOption(
            {setOption,
             QStringLiteral(
                 "For `add` and `set`: a value of the layer, for example size_mm=40;20, "
                 "place_mm=0;10;25, turn_deg=15, placement=cylinder or repeat_mm=8. spot=Varnish "
                 "prints the layer as a spot colour on its own plate. May be repeated."),
             QStringLiteral("KEY=VALUE")});
        syntax.addOption(
            {onOption,
             QStringLiteral(
                 "For `add`: the name of a face of a CAD model, or of a material. The "
                 "layer lies in its middle and shows only there. `info` lists the names."),
             QStringLiteral("NAME")});
        syntax.addOption({jsonOption, QStringLiteral("For `list`: prints JSON.")});
    }

    void run(const QCommandLineParser& parser, Console& console) const override {
        Words words(name(), parser.positionalArguments());
        const QString action = words.take(QStringLiteral("The action"));
        refuseOptionsOfOthers(parser,
                              {{QStringLiteral("list"), {jsonOption}},
                               {QStringLiteral("add"), {setOption, onOption}},
                               {QStringLiteral("set"), {setOption}},
                               {QStringLiteral("move"), {}},
                               {QStringLiteral("remove"), {}},
                               {QStringLiteral("base"), {}}},
                              action);
        const QString path = words.take(QStringLiteral("JOB.dipw"));
        if (action == QLatin1String("list")) {
            words.finish();
            list(loadProject(path), parser, console.out());
            return;
        }
        QString done; // told after the project has been saved
        QTextStream out(&done);
        ProjectFile file(path);
        const Project before = loadProject(path);
        Project project = before;
        if (action == QLatin1String("add")) {
            add(project, words, parser, out);
        } else if (action == QLatin1String("set")) {
            const std::size_t layer = takeLayer(words, project.artwork);
            words.finish();
            if (!parser.isSet(setOption)) {
                throw UsageError(QStringLiteral("Name what to change with --set KEY=VALUE"),
                                 QStringLiteral("--set"));
            }
            change(project, layer, parser);
            out << QStringLiteral("Changed %1\n").arg(project.artwork.layers[layer].name);
        } else if (action == QLatin1String("move")) {
            move(project.artwork, words, out);
        } else if (action == QLatin1String("remove")) {
            remove(project.artwork, words, out);
        } else if (action == QLatin1String("base")) {
            setBase(project, words, out);
        } else {
            throw UsageError(QStringLiteral("There is no such action; see --help"), action);
        }
        checkEditedSpots(before, project);
        file.save(project);
        console.out() << done;
    }
};

} // namespace

std::unique_ptr<Command> artworkCommand() {
    return std::make_unique<ArtworkCommand>();
}

} // namespace dipwright::cli
