#include "workbench/artwork/ArtworkController.h"

#include "artwork/EditArtwork.h"
#include "import/trusted/ReadPictures.h"
#include "model/NamedMaterials.h"
#include "pipeline/JobSheet.h"
#include "workbench/jobs/StartJob.h"
#include "workbench/project/NewProjectDialog.h"
#include "workbench/widgets/DroppedFiles.h"

#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMimeData>
#include <QPalette>

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

constexpr double handlePixels = 9; // a press this near takes hold of a handle

void setPlace(ArtworkLayer& layer, const Eigen::Vector3f& place) {
    for (int axis = 0; axis < 3; ++axis) {
        layer.place[std::size_t(axis)] =
            Millimetres(std::round(double(place[axis]) * 100) / 100 + 0.0);
    }
}

bool isPicture(const QString& path) {
    return pictureFilePatterns().contains(QStringLiteral("*.") +
                                          QFileInfo(path).suffix().toLower());
}

} // namespace

ArtworkController::ArtworkController(DipView& view, DipScene& scene, const DipSession& session,
                                     JobRunner& jobs, Messages& messages, QWidget& window)
    : QObject(&window), view_(view), scene_(scene), session_(session), jobs_(jobs),
      messages_(messages), window_(window), page_(new ArtworkPage) {
    connectPage();
    view.addStroke([this](const ViewRay& ray) { return beginDrag(ray); });
    view.setAcceptDrops(true);
    view.installEventFilter(this);
    page_->installEventFilter(this);
    connect(&view, &DipView::stroked, this, &ArtworkController::drag);
    connect(&view, &DipView::strokeFinished, this, &ArtworkController::endDrag);
    connect(&view, &DipView::clicked, this, &ArtworkController::selectAt);
}

void ArtworkController::connectPage() {
    connect(page_, &ArtworkPage::pictureAsked, this, &ArtworkController::askPicture);
    connect(page_, &ArtworkPage::layerAsked, this, [this](LayerKind kind) {
        const QString name = kind == LayerKind::Text         ? tr("Text")
                             : kind == LayerKind::Carbon     ? tr("Carbon")
                             : kind == LayerKind::Camouflage ? tr("Camouflage")
                                                             : tr("Wood");
        ArtworkLayer layer = newLayer(kind, name);
        layer.text = kind == LayerKind::Text ? name : QString();
        add(layer, std::nullopt);
    });
    connect(page_, &ArtworkPage::selected, this, &ArtworkController::select);
    connect(page_, &ArtworkPage::layerChanged, this,
            [this](int layer, const ArtworkLayer& changed, const QString& what) {
                edit(tr("Change layer"), QStringLiteral("artwork %1 %2").arg(layer).arg(what),
                     [&](Artwork& artwork) {
                         ArtworkLayer& old = artwork.layers[std::size_t(layer)];
                         old = placedAgain(old, changed, what);
                     });
            });
    connect(page_, &ArtworkPage::baseChanged, this, [this](const std::optional<QColor>& base) {
        edit(tr("Change base colour"), {}, [&](Artwork& artwork) { artwork.base = base; });
    });
    connect(page_, &ArtworkPage::moveAsked, this, &ArtworkController::move);
    connect(page_, &ArtworkPage::removeAsked, this, &ArtworkController::remove);
}

void ArtworkController::showDocument() {
    disconnect(shown_);
    selected_ = -1;
    drag_.reset();
    if (document()) {
        shown_ =
            connect(document(), &Document::projectChanged, this, &ArtworkController::showArtwork);
    }
    showArtwork();
}

const ArtworkLayer* ArtworkController::selectedLayer() const {
    if (!document() || selected_ < 0) {
        return nullptr;
    }
    const std::vector<ArtworkLayer>& layers = document()->project().artwork.layers;
    return std::size_t(selected_) < layers.size() ? &layers[std::size_t(selected_)] : nullptr;
}

std::optional<LayerFrame> ArtworkController::frame() const {
    const ArtworkLayer* layer = selectedLayer();
    const bool isShown = layer && layer->visible && layer->placement == LayerPlacement::Decal &&
                         page_ && page_->isVisible() && scene_.model() &&
                         scene_.model() == document()->project().model;
    return isShown ? std::optional<LayerFrame>(std::in_place, *layer, scene_) : std::nullopt;
}

void ArtworkController::select(int layer) {
    selected_ = layer;
    if (document()) {
        document()->endMerge();
    }
    showArtwork();
}

void ArtworkController::showArtwork() {
    if (!page_) {
        return;
    }
    page_->setEnabled(document());
    const Artwork artwork = document() ? document()->project().artwork : Artwork();
    selected_ = std::min(selected_, int(artwork.layers.size()) - 1);
    page_->setMaterials(document() ? materialNames(*document()->project().model) : QStringList());
    page_->show(artwork, selected_);
    const auto shown = frame();
    scene_.setFrame(shown ? shown->lines(view_.palette().color(QPalette::Highlight))
                          : std::vector<ViewLine>());
}

ArtworkLayer ArtworkController::placedAgain(const ArtworkLayer& before, const ArtworkLayer& changed,
                                            const QString& what) const {
    const TexturedMesh& model = *document()->project().model;
    if (what == QLatin1String("layerMaterial") && !changed.material.isEmpty()) {
        return movedOnto(model, changed, changed.material);
    }
    if (what == QLatin1String("layerPlacement")) {
        return replacedAs(changed.placement, model, before);
    }
    return changed;
}

void ArtworkController::edit(const QString& text, const QString& mergeKey,
                             const std::function<void(Artwork&)>& change) {
    try {
        document()->edit(text, mergeKey, [&](Project& project) {
            change(project.artwork);
            checkEditedSpots(document()->project(), project);
        });
    } catch (const Error&) {
        messages_.fail(text, std::current_exception());
        showArtwork();
    }
}

void ArtworkController::add(const ArtworkLayer& layer,
                            const std::optional<Eigen::Vector3f>& place) {
    const TexturedMesh& model = *document()->project().model;
    ArtworkLayer placed = placedOn(model, layer);
    if (place) {
        setPlace(placed, *place);
    }
    const std::size_t before = document()->project().artwork.layers.size();
    edit(tr("Add %1").arg(layer.name), {},
         [&](Artwork& artwork) { addLayer(artwork, placed, model); });
    if (document()->project().artwork.layers.size() > before) {
        select(int(before));
    }
}

void ArtworkController::addPicture(const QString& path,
                                   const std::optional<Eigen::Vector3f>& place) {
    startJob(
        jobs_, messages_, tr("Reading the picture"), tr("Add picture"),
        [path](const Progress&) { return artworkPicture(readPictureFile(path)); },
        [this, path, place, asked = QPointer<Document>(document())](const ArtworkPicture& picture) {
            if (asked && asked == document()) {
                ArtworkLayer layer =
                    newLayer(LayerKind::Picture, QFileInfo(path).completeBaseName());
                layer.picture = picture;
                add(layer, place);
                if (const QString note = colourNoteOf(layer); !note.isEmpty()) {
                    messages_.notice(note + u'.');
                }
            }
        });
}

void ArtworkController::askPicture() {
    const QString path =
        QFileDialog::getOpenFileName(&window_, tr("Add picture"), {}, pictureFileFilter());
    if (!path.isEmpty()) {
        addPicture(path, std::nullopt);
    }
}

void ArtworkController::move(int layer, int by) {
    const int other = layer + by;
    if (other < 0 || std::size_t(other) >= document()->project().artwork.layers.size()) {
        return;
    }
    edit(tr("Move layer"), {}, [&](Artwork& artwork) {
        std::swap(artwork.layers[std::size_t(layer)], artwork.layers[std::size_t(other)]);
    });
    select(other);
}

void ArtworkController::remove(int layer) {
    edit(tr("Remove layer"), {}, [&](Artwork& artwork) {
        artwork.layers.erase(artwork.layers.begin() + layer);
        if (artwork.layers.empty() && artwork.base == QColor(255, 255, 255)) {
            artwork.base.reset(); // the first layer set it
        }
    });
}

bool ArtworkController::beginDrag(const ViewRay& ray) {
    const std::optional<LayerFrame> held = frame();
    if (!held) {
        return false;
    }
    const Eigen::Vector3f middle = held->place().cast<float>();
    double pixels = 0; // per millimetre
    for (int axis = 0; axis < 3; ++axis) {
        const QPointF step =
            view_.positionOf(scene_.toWorld(middle + Eigen::Vector3f::Unit(axis))) -
            view_.positionOf(scene_.toWorld(middle));
        pixels = std::max(pixels, std::hypot(step.x(), step.y()));
    }
    const auto handle = held->handleAt(ray, handlePixels / std::max(pixels, 1e-3));
    if (!handle) {
        return false;
    }
    drag_.emplace(Drag{*handle, ray, held});
    emit this->held(true);
    return true;
}

void ArtworkController::drag(const ViewRay& ray) {
    if (!drag_ || !selectedLayer()) {
        return;
    }
    const ArtworkLayer changed = drag_->frame->dragged(drag_->handle, drag_->from, ray);
    const auto index = std::size_t(selected_);
    const QString text = drag_->handle == FrameHandle::Move   ? tr("Move layer")
                         : drag_->handle == FrameHandle::Turn ? tr("Turn layer")
                                                              : tr("Resize layer");
    edit(text, QStringLiteral("artwork drag"),
         [&](Artwork& artwork) { artwork.layers[index] = changed; });
}

void ArtworkController::endDrag() {
    if (drag_) {
        drag_.reset();
        document()->endMerge();
        emit held(false);
    }
}

// Selects the top decal at this place. Keeps the selection if there is none.
void ArtworkController::selectAt(const ViewRay& ray) {
    if (!document() || !page_->isVisible() || !scene_.model()) {
        return;
    }
    const std::vector<ArtworkLayer>& layers = document()->project().artwork.layers;
    for (int layer = int(layers.size()) - 1; layer >= 0; --layer) {
        const ArtworkLayer& candidate = layers[std::size_t(layer)];
        if (candidate.visible && candidate.placement == LayerPlacement::Decal &&
            LayerFrame(candidate, scene_).handleAt(ray, 0) == FrameHandle::Move) {
            select(layer);
            return;
        }
    }
}

bool ArtworkController::dropOnBody(const QStringList& files, const QPointF& position) {
    const auto place = document() ? scene_.modelPoint(view_.rayAt(position)) : std::nullopt;
    if (!place || files.isEmpty() || !std::all_of(files.begin(), files.end(), isPicture)) {
        return false;
    }
    for (const QString& file : files) {
        addPicture(file, place);
    }
    return true;
}

bool ArtworkController::eventFilter(QObject* watched, QEvent* event) {
    if (watched == page_ && (event->type() == QEvent::Show || event->type() == QEvent::Hide)) {
        QMetaObject::invokeMethod(this, &ArtworkController::showArtwork, Qt::QueuedConnection);
    }
    if (watched != &view_) {
        return QObject::eventFilter(watched, event);
    }
    if (event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove) {
        auto* dragged = static_cast<QDragMoveEvent*>(event);
        dragged->setAccepted(!droppedFiles(*dragged->mimeData()).isEmpty());
        return true;
    }
    if (event->type() == QEvent::Drop) {
        auto* dropped = static_cast<QDropEvent*>(event);
        const QStringList files = droppedFiles(*dropped->mimeData());
        if (!dropOnBody(files, dropped->position())) {
            emit filesDropped(files);
        }
        dropped->acceptProposedAction();
        return true;
    }
    if (event->type() == QEvent::KeyPress && frame()) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Delete) {
            remove(selected_);
            return true;
        }
        if (key == Qt::Key_Escape) {
            select(-1);
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

} // namespace dipwright
