#include "proof/ProofPage.h"

#include "base/Error.h"
#include "base/ProgramName.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QCryptographicHash>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <utility>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Proof)
};

constexpr int jpegQuality = 82;

QByteArray resource(const QString& name) {
    QFile file(QStringLiteral(":/dipwright/") + name);
    if (!file.open(QIODevice::ReadOnly)) {
        throw Error(Text::tr("This program was built without three.js, which shows the proof in a "
                             "browser. Build it with the package libjs-three installed, or share "
                             "proof.png"),
                    {});
    }
    return file.readAll();
}

// Returns the file's three.js scripts and the page's own, in the order of loading.
QByteArray script() {
    QByteArray all;
    for (const char* name : {"three/three.min.js", "three/OrbitControls.js", "three/GLTFLoader.js",
                             "proof/viewer.js"}) {
        all += resource(QLatin1String(name)) + '\n';
    }
    return all;
}

QByteArray hashOf(const QByteArray& text) {
    return "'sha256-" + QCryptographicHash::hash(text, QCryptographicHash::Sha256).toBase64() +
           '\'';
}

QByteArray escaped(const QString& text) {
    return text.toHtmlEscaped().toUtf8();
}

QByteArray element(const char* name, const QByteArray& inner) {
    return QByteArray("<") + name + '>' + inner + "</" + name + '>';
}

QByteArray pictureHtml(const QImage& picture, const QString& text) {
    QByteArray jpeg;
    QBuffer buffer(&jpeg);
    buffer.open(QIODevice::WriteOnly);
    picture.convertToFormat(QImage::Format_RGB888).save(&buffer, "JPG", jpegQuality);
    return "<img alt=\"" + escaped(text) + "\" width=\"" + QByteArray::number(picture.width()) +
           "\" height=\"" + QByteArray::number(picture.height()) +
           "\" src=\"data:image/jpeg;base64," + jpeg.toBase64() + "\">";
}

QByteArray sectionsHtml(const ProofPage& page) {
    QByteArray html;
    for (const ProofSection& section : page.sections) {
        html += "<section>" + element("h2", escaped(section.title)) + "<dl>";
        for (const ProofFigure& figure : section.figures) {
            html += element("div", element("dt", escaped(figure.name)) +
                                       element("dd", escaped(figure.value)));
        }
        html += "</dl></section>";
    }
    return html;
}

QByteArray sheetsHtml(const ProofPage& page) {
    QByteArray html;
    for (const ProofSheet& sheet : page.sheets) {
        html += "<figure>" + pictureHtml(sheet.picture, sheet.title) + "<figcaption>" +
                element("strong", escaped(sheet.title)) + ' ' + escaped(sheet.text) +
                "</figcaption></figure>";
    }
    return html;
}

QByteArray reasonsHtml(const ProofPage& page) {
    QByteArray html;
    for (const QString& reason : page.reasons) {
        html += element("li", escaped(reason));
    }
    return html.isEmpty() ? html : element("ul", html);
}

QByteArray layersHtml(const ProofPage& page) {
    QByteArray html;
    for (const ProofLegend& layer : page.layers) {
        html += "<label><input type=\"radio\" name=\"layer\" value=\"" + escaped(layer.key) +
                "\"><span>" + escaped(layer.name) + "</span></label>";
    }
    return html;
}

// Returns the data of the layers for the viewer. "<" is escaped so that no text ends the element.
QByteArray layersJson(const ProofPage& page) {
    QJsonArray layers;
    for (const ProofLegend& layer : page.layers) {
        QJsonArray steps;
        for (const ProofLegend::Step& step : layer.steps) {
            steps.append(QJsonObject{{"colour", step.colour.name()}, {"text", step.text}});
        }
        layers.append(
            QJsonObject{{"key", layer.key}, {"explanation", layer.explanation}, {"steps", steps}});
    }
    return QJsonDocument(layers).toJson(QJsonDocument::Compact).replace('<', "\\u003c");
}

QByteArray viewsHtml() {
    QByteArray html;
    for (const auto& [key, name] :
         {std::pair("front", Text::tr("Front")), std::pair("right", Text::tr("Right")),
          std::pair("back", Text::tr("Back")), std::pair("left", Text::tr("Left")),
          std::pair("above", Text::tr("Above")), std::pair("below", Text::tr("Below"))}) {
        html += QByteArray("<button type=\"button\" data-view=\"") + key + "\">" + escaped(name) +
                "</button>";
    }
    return html;
}

// Replaces each @NAME@ of the template, in one pass, so that values are never searched.
QByteArray filled(const QByteArray& text,
                  const std::vector<std::pair<QByteArray, QByteArray>>& by) {
    QByteArray result;
    qsizetype at = 0;
    while (true) {
        const qsizetype begin = text.indexOf('@', at);
        const qsizetype end = begin < 0 ? -1 : text.indexOf('@', begin + 1);
        if (end < 0) {
            return result + text.mid(at);
        }
        result += text.mid(at, begin - at);
        const QByteArray name = text.mid(begin + 1, end - begin - 1);
        for (const auto& [known, value] : by) {
            result += known == name ? value : QByteArray();
        }
        at = end + 1;
    }
}

} // namespace

QByteArray proofHtml(const ProofPage& page) {
    const QByteArray code = script(), style = resource(QStringLiteral("proof/style.css"));
    const QByteArray policy = "default-src 'none'; img-src data: blob:; script-src " +
                              hashOf(code) + "; style-src " + hashOf(style);
    return filled(
        resource(QStringLiteral("proof/page.html")),
        {{"LANGUAGE", QLocale().bcp47Name().toUtf8()},
         {"POLICY", policy},
         {"STYLE", style},
         {"SCRIPT", code},
         {"TITLE", escaped(page.title)},
         {"PROOF", escaped(Text::tr("Proof"))},
         {"JOB", escaped(Text::tr("Job %1").arg(page.job))},
         {"DATE", escaped(page.date)},
         {"VERDICT", escaped(page.verdict)},
         {"VERDICT_KEY", escaped(page.verdictKey)},
         {"REASONS", reasonsHtml(page)},
         {"LAYER", escaped(Text::tr("Layer"))},
         {"LAYERS", layersHtml(page)},
         {"LAYERS_DATA", layersJson(page)},
         {"VIEW", escaped(Text::tr("View"))},
         {"VIEWS", viewsHtml()},
         {"PART", escaped(Text::tr("The part. Arrow keys turn it, plus and minus zoom, 0 resets"))},
         {"HELP", escaped(Text::tr("Drag to turn. Wheel or two fingers zoom and move. Arrow keys "
                                   "turn, + and − zoom."))},
         {"NO_3D", escaped(Text::tr("This browser cannot draw in 3D (WebGL). The picture shows the "
                                    "part from six sides."))},
         {"FALLBACK", pictureHtml(page.fallback, Text::tr("The part from six sides"))},
         {"SECTIONS", sectionsHtml(page)},
         {"SHEETS_TITLE", escaped(Text::tr("Sheets, ink side up"))},
         {"SHEETS", sheetsHtml(page)},
         {"NOTE", escaped(page.note)},
         {"MADE_BY", escaped(Text::tr("Made by %1. The viewer is three.js.")
                                 .arg(QStringLiteral("Dipwright ") + programVersion()))},
         {"LICENCE", escaped(Text::tr("Licence of the viewer"))},
         {"LICENCE_TEXT", escaped(QString::fromUtf8(resource(QStringLiteral("three/copyright"))))},
         {"MODEL", page.glb.toBase64()}});
}

} // namespace dipwright
