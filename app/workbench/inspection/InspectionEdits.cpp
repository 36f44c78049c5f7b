#include "workbench/inspection/InspectionEdits.h"

#include <QCoreApplication>
#include <QPointF>

#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(InspectionEdits)
};

// Adds the photos whose file is not there yet, up to `most`.
template <typename P>
void addNew(std::vector<P>& photos, const std::vector<P>& added, std::size_t most) {
    for (const P& one : added) {
        const bool isThere = std::any_of(photos.begin(), photos.end(),
                                         [&](const P& photo) { return photo.file == one.file; });
        if (!isThere && photos.size() < most) {
            photos.push_back(one);
        }
    }
}

} // namespace

void addInspectedPhotos(Document& document, const std::vector<InspectedPhoto>& added) {
    document.edit(Text::tr("Add photos"), {}, [&](Project& project) {
        addNew(project.inspection.photos, added, mostInspectedPhotos);
    });
}

void removeInspectedPhoto(Document& document, std::size_t photo) {
    document.edit(Text::tr("Remove photo"), {}, [&](Project& project) {
        InspectedPart& part = project.inspection;
        if (photo >= part.photos.size()) {
            return;
        }
        part.photos.erase(part.photos.begin() + std::ptrdiff_t(photo));
        std::erase_if(part.pairs,
                      [&](const ClickedPair& pair) { return std::size_t(pair.photo) == photo; });
        for (ClickedPair& pair : part.pairs) {
            pair.photo -= std::size_t(pair.photo) > photo;
        }
    });
}

void addClickedPair(Document& document, const ClickedPair& pair) {
    document.edit(Text::tr("Add pair of places"), {}, [&](Project& project) {
        if (project.inspection.pairs.size() < mostClickedPairs) {
            project.inspection.pairs.push_back(pair);
        }
    });
}

void moveClickedPair(Document& document, std::size_t pair, QPointF pixel) {
    document.edit(Text::tr("Move place in photo"), QStringLiteral("inspection.pair"),
                  [&](Project& project) {
                      if (pair < project.inspection.pairs.size()) {
                          project.inspection.pairs[pair].pixel = {pixel.x(), pixel.y()};
                      }
                  });
}

void removeClickedPair(Document& document, std::size_t pair) {
    document.edit(Text::tr("Remove pair of places"), {}, [&](Project& project) {
        std::vector<ClickedPair>& pairs = project.inspection.pairs;
        if (pair < pairs.size()) {
            pairs.erase(pairs.begin() + std::ptrdiff_t(pair));
        }
    });
}

void addFloatingPhotos(Document& document, const std::vector<FloatingPhoto>& added) {
    document.edit(Text::tr("Add photos"), {}, [&](Project& project) {
        addNew(project.filmOnWater.photos, added, mostFloatingPhotos);
    });
}

void changeFilmOnWater(Document& document, const FilmOnWater& film, const QString& what) {
    document.edit(Text::tr("Change film measurement"),
                  what.isEmpty() ? QString() : QStringLiteral("inspection.film.") + what,
                  [&](Project& project) { project.filmOnWater = film; });
}

void keepBuilt(Document& document, const AsBuilt& built) {
    document.edit(Text::tr("Keep part"), {}, [&](Project& project) { project.asBuilt = built; });
}

void setCorrects(Document& document, bool corrects) {
    document.edit(Text::tr("Correct the next sheets"), {},
                  [&](Project& project) { project.asBuilt.corrects = corrects; });
}

void setCorrectionStrength(Document& document, double strength) {
    document.edit(Text::tr("Change strength of correction"), QStringLiteral("as_built.strength"),
                  [&](Project& project) { project.asBuilt.strength = strength; });
}

void useFit(Document& document, const FittedPart& fitted, const WatchNotes& notes) {
    requireUncorrected(document.project(), document.project().name);
    document.edit(Text::tr("Use fit in project"), {}, [&](Project& project) {
        project = withFit(project, fitted.fit, fitted.photos, notes,
                          Text::tr("Measured %1").arg(notes.date));
    });
}

} // namespace dipwright
