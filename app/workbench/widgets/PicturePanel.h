// A picture with zoom buttons and buttons for its actions.
#pragma once

#include "workbench/widgets/PictureView.h"

class QAction;
class QLabel;
class QToolBar;

namespace dipwright {

class PicturePanel : public QWidget {
    Q_OBJECT

public:
    PicturePanel(const QString& name, const QString& hint, QWidget* parent = nullptr);

    PictureView& view() { return *view_; }
    void setPicture(const QImage& picture, QSizeF millimetres);
    void clear();
    // Sets the text under the picture, which is rich text; empty: none.
    void setLegend(const QString& text);
    // Adds a separator and a button to the right of the others. Its owner enables it: a picture
    // that is shown may be a draft, which must not be exported.
    void addButton(QAction* action);
    void offerTrueSize();

private:
    void takeFocus(QAction* action);

    QString hint_;
    PictureView* view_;
    QToolBar* bar_;
    QLabel* zoomLabel_;
    QLabel* legend_;
    QList<QAction*> zoomButtons_; // enabled while there is a picture
};

} // namespace dipwright
