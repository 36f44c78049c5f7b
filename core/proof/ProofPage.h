// Makes proof.html: one page that shows proof.glb to turn, with the figures of the job
// (docs/proof.md). It needs no other file and no network.
#pragma once

#include <QByteArray>
#include <QColor>
#include <QImage>
#include <QString>
#include <QStringList>
#include <vector>

namespace dipwright {

// The legend of a layer of the model, in the layers' order.
struct ProofLegend {
    QString key, name; // as in ProofLayer
    QString explanation;
    struct Step {
        QColor colour;
        QString text; // may be empty
    };
    std::vector<Step> steps; // from low to high values; empty: the layer shows colours themselves
};

struct ProofFigure {
    QString name, value;
};

// The figures of one dip, or of the whole job.
struct ProofSection {
    QString title;
    std::vector<ProofFigure> figures;
};

struct ProofSheet {
    QImage picture; // film image on white, reduced
    QString title, text;
};

struct ProofPage {
    QString title;      // name of the project
    QString job, date;  // job number of all dips together; ISO date
    QString verdict;    // as the user reads it
    QString verdictKey; // "print", "look_first", "do_not_print" or "not_judged"
    QStringList reasons;
    std::vector<ProofLegend> layers;
    std::vector<ProofSection> sections;
    std::vector<ProofSheet> sheets;
    QString note;    // on the model
    QImage fallback; // shown without WebGL and on paper
    QByteArray glb;
};

// Returns the page, in the program's language. All texts are escaped. Scripts other than the page's
// own, and all requests, are forbidden by its content security policy. Equal input gives equal
// bytes. Throws Error if the program was built without the viewer's library.
QByteArray proofHtml(const ProofPage& page);

} // namespace dipwright
