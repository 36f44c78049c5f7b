#include "workbench/appearance/MarkLines.h"

#include "results/Results.h"
#include "share/ShareMarks.h"

#include <algorithm>

namespace dipwright {

QColor shareMarkColour(ShareMarkKind kind) {
    switch (kind) {
    case ShareMarkKind::First:
        return painterColour(Painter::First).lighter(140);
    case ShareMarkKind::Second:
        return painterColour(Painter::Second).lighter(120);
    case ShareMarkKind::Avoid:
        return {170, 20, 40};
    case ShareMarkKind::Allow:
        return {200, 230, 90};
    case ShareMarkKind::None:
        return {150, 150, 150};
    }
    return {};
}

MarkLines::MarkLines(const TriangleMesh& body)
    : mesh_(body, fineEdge(body)), query_(mesh_.mesh()) {}

std::vector<ViewLine> MarkLines::lines(const std::vector<ShareMark>& marks) {
    std::vector<Drawn> drawn;
    std::vector<ViewLine> all;
    for (const ShareMark& mark : marks) {
        const auto known = std::find_if(drawn_.begin(), drawn_.end(),
                                        [&](const Drawn& other) { return other.mark == mark; });
        if (known != drawn_.end()) {
            drawn.push_back(*known);
        } else {
            drawn.push_back({mark, {}});
            for (const auto& ends : markOutline(mesh_.mesh(), query_, mark)) {
                drawn.back().lines.push_back({ends, shareMarkColour(mark.kind)});
            }
        }
        all.insert(all.end(), drawn.back().lines.begin(), drawn.back().lines.end());
    }
    drawn_ = std::move(drawn);
    return all;
}

} // namespace dipwright
