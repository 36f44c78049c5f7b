#include "workbench/document/MarkEdits.h"

#include "base/Error.h"

#include <QCoreApplication>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(MarkEdits)
};

template <typename Mark>
struct Marks;

template <>
struct Marks<ShareMark> {
    static constexpr std::size_t most = mostShareMarks;
    static std::vector<ShareMark>& of(Project& project) { return project.share.marks; }
};

template <>
struct Marks<ZoneMark> {
    static constexpr std::size_t most = mostZoneMarks;
    static std::vector<ZoneMark>& of(Project& project) { return project.tolerance.marks; }
};

template <>
struct Marks<MaskMark> {
    static constexpr std::size_t most = mostMaskMarks;
    static std::vector<MaskMark>& of(Project& project) { return project.masks; }
};

bool isStroke(const ShareMark& mark) {
    return mark.radius.value() > 0;
}

bool isStroke(const SurfaceMark& mark) {
    return mark.extent == MarkExtent::Stroke;
}

QString nameOf(const ShareMark& mark) {
    return mark.kind == ShareMarkKind::None ? Text::tr("Erase marks for the seam")
                                            : Text::tr("Mark area for the seam");
}

QString nameOf(const ZoneMark&) {
    return Text::tr("Mark zone");
}

QString nameOf(const MaskMark& mark) {
    return mark.erases ? Text::tr("Erase mask") : Text::tr("Mask area");
}

template <typename Mark>
void add(Document& document, const std::vector<Mark>& added) {
    document.edit(nameOf(added.front()), {}, [&](Project& project) {
        std::vector<Mark>& marks = Marks<Mark>::of(project);
        marks.insert(marks.end(), added.begin(), added.end());
        std::size_t points = 0;
        for (const Mark& mark : marks) {
            points += mark.path.size();
        }
        if (marks.size() > Marks<Mark>::most || points > mostBrushPointsOfAll) {
            throw Error(Text::tr("The project holds as many marks of this kind as it can; remove "
                                 "some to mark more"),
                        {});
        }
    });
}

// Calls `what` with the mark of a brush.
template <typename What>
void withMark(const MarkBrush& brush, const What& what) {
    std::visit(
        [&]<typename Mark>(const Mark& mark) {
            if constexpr (!std::is_same_v<Mark, std::monostate>) {
                what(mark);
            }
        },
        brush);
}

} // namespace

bool drawsStrokes(const MarkBrush& brush) {
    bool draws = false;
    withMark(brush, [&](const auto& mark) { draws = isStroke(mark); });
    return draws;
}

MarkBrush eraserOf(const MarkBrush& brush) {
    MarkBrush eraser = brush;
    if (auto* seam = std::get_if<ShareMark>(&eraser)) {
        seam->kind = ShareMarkKind::None;
    } else if (auto* zone = std::get_if<ZoneMark>(&eraser)) {
        zone->zone = Zone::C;
    } else if (auto* mask = std::get_if<MaskMark>(&eraser)) {
        mask->erases = true;
    }
    return eraser;
}

void addStrokes(Document& document, const MarkBrush& brush, const std::vector<BrushPath>& paths) {
    withMark(brush, [&]<typename Mark>(const Mark& mark) {
        std::vector<Mark> strokes;
        for (const BrushPath& path : paths) {
            strokes.push_back(mark);
            strokes.back().place = path.front().place;
            strokes.back().path = path;
        }
        add(document, strokes);
    });
}

MarkBrush materialBrush(const MarkBrush& brush) {
    MarkBrush whole = brush;
    withMark(brush, [&]<typename Mark>(Mark mark) {
        if constexpr (std::is_base_of_v<SurfaceMark, Mark>) {
            mark.extent = MarkExtent::Material;
            whole = mark;
        }
    });
    return whole;
}

void addMark(Document& document, const MarkBrush& brush, const std::array<Millimetres, 3>& place,
             const QString& material) {
    withMark(brush, [&]<typename Mark>(Mark mark) {
        mark.place = place;
        if constexpr (std::is_base_of_v<SurfaceMark, Mark>) {
            mark.material = mark.extent == MarkExtent::Material ? material : QString();
        }
        add(document, std::vector<Mark>{mark});
    });
}

template <typename Mark>
void removeLastMark(Document& document) {
    document.edit(Text::tr("Remove mark"), {}, [](Project& project) {
        std::vector<Mark>& marks = Marks<Mark>::of(project);
        if (!marks.empty()) {
            marks.pop_back();
        }
    });
}

template <typename Mark>
void removeMarks(Document& document) {
    document.edit(Text::tr("Remove marks"), {},
                  [](Project& project) { Marks<Mark>::of(project).clear(); });
}

template void removeLastMark<ShareMark>(Document&);
template void removeLastMark<ZoneMark>(Document&);
template void removeLastMark<MaskMark>(Document&);
template void removeMarks<ShareMark>(Document&);
template void removeMarks<ZoneMark>(Document&);
template void removeMarks<MaskMark>(Document&);

} // namespace dipwright
