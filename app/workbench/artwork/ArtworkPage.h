// The page that lists the artwork's layers and their fields. The page does not change the artwork;
// it emits the user's changes.
#pragma once

#include "settings/Artwork.h"

#include <QWidget>
#include <functional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFontComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QPushButton;
class QToolButton;

namespace dipwright {

class NumberBox;

class ArtworkPage : public QWidget {
    Q_OBJECT

public:
    explicit ArtworkPage(QWidget* parent = nullptr);

    // `selected`: the index of a layer; −1: none.
    void show(const Artwork& artwork, int selected);
    // Names of faces or materials, for a layer that shows only on one of them.
    void setMaterials(const QStringList& names);

signals:
    void pictureAsked();
    void layerAsked(dipwright::LayerKind kind); // text or a pattern
    void selected(int layer);
    // `what`: the name of the changed field.
    void layerChanged(int layer, const dipwright::ArtworkLayer& changed, const QString& what);
    void baseChanged(const std::optional<QColor>& base);
    void moveAsked(int layer, int by); // positive: upwards
    void removeAsked(int layer);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void makeList();
    void makeBase();
    void makeFields();
    void makePlaceFields(QFormLayout& form);
    void makeSpotFields(QFormLayout& form);
    QDoubleSpinBox* addNumber(QFormLayout& form, const char* name, const QString& label,
                              const QString& help, double least, double most, const QString& suffix,
                              const std::function<void(ArtworkLayer&, double)>& set);
    QPushButton* addColour(QFormLayout& form, const char* name, const QString& label,
                           QColor ArtworkLayer::*colour);
    void change(const QString& what, const std::function<void(ArtworkLayer&)>& set);
    void askColour(const QColor& now, const std::function<void(const QColor&)>& chosen);
    void showList();
    void showFields();
    int rowOf(int layer) const;

    Artwork artwork_;
    int selected_ = -1;
    bool isShowing_ = false; // while the page fills its fields
    QListWidget* list_;
    QToolButton *up_, *down_, *remove_;
    QCheckBox* hasBase_;
    QPushButton* base_;
    QWidget* fields_;
    QFormLayout* form_ = nullptr;
    QPlainTextEdit* text_;
    QFontComboBox* font_;
    QPushButton *colour_, *secondColour_;
    NumberBox* seed_;
    QDoubleSpinBox *opacity_, *turn_, *repeat_;
    std::array<QDoubleSpinBox*, 2> size_{};
    QLabel* shownSize_; // the size at which the layer is printed
    std::array<QDoubleSpinBox*, 3> place_{};
    QComboBox *placement_, *axis_, *material_;
    QLineEdit* spot_;
    QPushButton* spotColour_;
    QCheckBox* spotFirst_;
};

} // namespace dipwright
