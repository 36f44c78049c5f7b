// Controls the artwork of a window: its page, the frame around a decal in the view, and pictures
// dropped on the body. Every change is an undo step.
#pragma once

#include "workbench/artwork/ArtworkPage.h"
#include "workbench/artwork/LayerFrame.h"
#include "workbench/dip/DipSession.h"
#include "workbench/jobs/Messages.h"

#include <QPointer>
#include <QStringList>

namespace dipwright {

class ArtworkController : public QObject {
    Q_OBJECT

public:
    ArtworkController(DipView& view, DipScene& scene, const DipSession& session, JobRunner& jobs,
                      Messages& messages, QWidget& window);

    ArtworkPage* page() const { return page_; } // its window owns it
    // Call this when the session has another document.
    void showDocument();

signals:
    void held(bool isHeld); // a drag begins or ends
    // The user dropped files on the view that do not become artwork.
    void filesDropped(const QStringList& files);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Drag {
        FrameHandle handle;
        ViewRay from;
        std::optional<LayerFrame> frame; // as it was when the drag began
    };
    void connectPage();
    Document* document() const { return session_.document(); }
    const ArtworkLayer* selectedLayer() const; // null: none
    std::optional<LayerFrame> frame() const;   // nullopt unless a visible decal is selected
    void select(int layer);
    void showArtwork();
    // Returns a layer with a change of the field `what`, moved to where the change asks for it.
    ArtworkLayer placedAgain(const ArtworkLayer& before, const ArtworkLayer& changed,
                             const QString& what) const;
    void edit(const QString& text, const QString& mergeKey,
              const std::function<void(Artwork&)>& change);
    void add(const ArtworkLayer& layer, const std::optional<Eigen::Vector3f>& place);
    void addPicture(const QString& path, const std::optional<Eigen::Vector3f>& place);
    void askPicture();
    void move(int layer, int by);
    void remove(int layer);
    bool beginDrag(const ViewRay& ray);
    void drag(const ViewRay& ray);
    void endDrag();
    void selectAt(const ViewRay& ray);
    bool dropOnBody(const QStringList& files, const QPointF& position);

    DipView& view_;
    DipScene& scene_;
    const DipSession& session_;
    JobRunner& jobs_;
    Messages& messages_;
    QWidget& window_;
    QPointer<ArtworkPage> page_;
    QMetaObject::Connection shown_; // to the shown document
    int selected_ = -1;
    std::optional<Drag> drag_;
};

} // namespace dipwright
