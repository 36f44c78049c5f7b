// The artwork of a window: its page, the frame by which a decal is moved, turned and sized in the
// view, and pictures dropped on the body. Every change is a step to undo.
#pragma once

#include "workbench/artwork/ArtworkPage.h"
#include "workbench/artwork/LayerFrame.h"
#include "workbench/dip/DipSession.h"
#include "workbench/jobs/Messages.h"

#include <QPointer>
#include <QUrl>

namespace dipwright {

class ArtworkController : public QObject {
    Q_OBJECT

public:
    ArtworkController(DipView& view, DipScene& scene, const DipSession& session, JobRunner& jobs,
                      Messages& messages, QWidget& window);

    ArtworkPage* page() const { return page_; } // belongs to who puts it into a window
    // To be called when the session has another document.
    void showDocument();

signals:
    void held(bool isHeld);                       // as long as something is dragged
    void droppedBeside(const QList<QUrl>& files); // on the view, and not pictures on the body

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
    std::optional<LayerFrame> frame() const;   // of a decal that is selected and shown
    void select(int layer);
    void showArtwork();
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
    QMetaObject::Connection shown_; // to the document
    int selected_ = -1;
    std::optional<Drag> drag_;
};

} // namespace dipwright
