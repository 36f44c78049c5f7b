#include "workbench/artwork/ArtworkPage.h"

#include "artwork/EditArtwork.h"
#include "base/NumberText.h"
#include "settings/SurfaceMark.h"
#include "workbench/widgets/Icons.h"
#include "workbench/widgets/NumberBox.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QFontComboBox>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPainter>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpressionValidator>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStringList>
#include <QToolButton>
#include <QVBoxLayout>

namespace dipwright {
namespace {

constexpr int swatchSize = 16, listHeight = 110, textHeight = 52;

QIcon swatch(const QColor& colour) {
    QPixmap pixmap(swatchSize, swatchSize);
    pixmap.fill(Qt::gray); // a frame, for white on white
    QPainter(&pixmap).fillRect(pixmap.rect().adjusted(1, 1, -1, -1), colour);
    return pixmap;
}

QWidget* inARow(const QList<QWidget*>& widgets) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    for (QWidget* widget : widgets) {
        layout->addWidget(widget);
    }
    return row;
}

} // namespace

ArtworkPage::ArtworkPage(QWidget* parent) : QWidget(parent), list_(new QListWidget) {
    setObjectName(QStringLiteral("artworkPage"));
    auto* inside = new QWidget;
    auto* column = new QVBoxLayout(inside);
    column->setContentsMargins(4, 6, 4, 6); // narrow: the German buttons are wide
    auto* scroll = new QScrollArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setWidget(inside);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);

    auto* picture = new QPushButton(tr("Add &picture…"));
    picture->setObjectName(QStringLiteral("addPicture"));
    picture->setToolTip(
        tr("Places a picture on the part. You can also drop a picture on the part in the view."));
    connect(picture, &QPushButton::clicked, this, &ArtworkPage::pictureAsked);
    auto* text = new QPushButton(tr("Add &text"));
    text->setObjectName(QStringLiteral("addText"));
    connect(text, &QPushButton::clicked, this, [this] { emit layerAsked(LayerKind::Text); });
    auto* pattern = new QPushButton(tr("Add p&attern"));
    pattern->setObjectName(QStringLiteral("addPattern"));
    auto* patterns = new QMenu(pattern);
    const auto addPattern = [&](const char* name, const QString& words, LayerKind kind) {
        QAction* action = patterns->addAction(words, this, [this, kind] { emit layerAsked(kind); });
        action->setObjectName(QLatin1String(name));
    };
    addPattern("addCarbon", tr("Carbon"), LayerKind::Carbon);
    addPattern("addCamouflage", tr("Camouflage"), LayerKind::Camouflage);
    addPattern("addWood", tr("Wood"), LayerKind::Wood);
    pattern->setMenu(patterns);
    column->addWidget(inARow({picture, text}));
    column->addWidget(pattern);
    makeList();
    column->addWidget(list_);
    column->addWidget(inARow({up_, down_, remove_}));
    makeBase();
    column->addWidget(inARow({hasBase_, base_}));
    makeFields();
    column->addWidget(fields_);
    column->addStretch(1);
    show({}, -1);
}

void ArtworkPage::makeList() {
    list_->setObjectName(QStringLiteral("artworkLayers"));
    list_->setAccessibleName(tr("Layers, top layer first"));
    list_->setToolTip(tr("The layers, top layer first. The tick shows or hides a layer, a double "
                         "click renames it. Delete removes it, Ctrl+Up and Ctrl+Down move it."));
    list_->setMinimumHeight(listHeight);
    list_->installEventFilter(this);
    const auto layerOf = [this](int row) { return int(artwork_.layers.size()) - 1 - row; };
    connect(list_, &QListWidget::currentRowChanged, this, [this, layerOf](int row) {
        if (!isShowing_) {
            emit selected(row < 0 ? -1 : layerOf(row));
        }
    });
    connect(list_, &QListWidget::itemChanged, this, [this, layerOf](const QListWidgetItem* item) {
        if (isShowing_) {
            return;
        }
        const int layer = layerOf(list_->row(item));
        ArtworkLayer changed = artwork_.layers[std::size_t(layer)];
        const bool isVisible = item->checkState() == Qt::Checked;
        const QString what =
            isVisible != changed.visible ? QStringLiteral("visible") : QStringLiteral("name");
        changed.visible = isVisible;
        changed.name = item->text().left(longestLayerName);
        emit layerChanged(layer, changed, what);
    });
    const auto button = [this](const char* name, const QString& words, const QString& help,
                               auto what) {
        auto* made = new QToolButton;
        made->setObjectName(QLatin1String(name));
        made->setText(words);
        made->setToolTip(help);
        made->setFocusPolicy(Qt::StrongFocus);
        connect(made, &QToolButton::clicked, this, what);
        return made;
    };
    up_ = button("layerUp", tr("Up"), tr("Moves the layer up (Ctrl+Up)"),
                 [this] { emit moveAsked(selected_, 1); });
    down_ = button("layerDown", tr("Down"), tr("Moves the layer down (Ctrl+Down)"),
                   [this] { emit moveAsked(selected_, -1); });
    remove_ = button("removeLayer", tr("Remove"), tr("Removes the layer (Delete)"),
                     [this] { emit removeAsked(selected_); });
}

void ArtworkPage::makeBase() {
    hasBase_ = new QCheckBox(tr("Base colour"));
    hasBase_->setObjectName(QStringLiteral("hasBase"));
    hasBase_->setToolTip(tr("The colour below all layers. White: no ink is printed. Without a base "
                            "colour the model keeps its own colours."));
    base_ = new QPushButton;
    base_->setObjectName(QStringLiteral("baseColour"));
    base_->setAccessibleName(tr("Base colour"));
    connect(hasBase_, &QCheckBox::clicked, this, [this](bool isThere) {
        emit baseChanged(isThere ? std::optional(QColor(255, 255, 255)) : std::nullopt);
    });
    connect(base_, &QPushButton::clicked, this, [this] {
        askColour(artwork_.base.value_or(Qt::white),
                  [this](const QColor& colour) { emit baseChanged(colour); });
    });
}

QDoubleSpinBox* ArtworkPage::addNumber(QFormLayout& form, const char* name, const QString& label,
                                       const QString& help, double least, double most,
                                       const QString& suffix,
                                       const std::function<void(ArtworkLayer&, double)>& set) {
    auto* box = new NumberBox;
    box->setObjectName(QLatin1String(name));
    box->setAccessibleName(label);
    box->setToolTip(help);
    box->setDecimals(2);
    box->setRange(least, most);
    box->setSuffix(suffix);
    box->setKeyboardTracking(false); // a typed number is one change
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, name, set](double value) {
        change(QLatin1String(name), [&](ArtworkLayer& layer) { set(layer, value); });
    });
    form.addRow(label, box);
    return box;
}

QPushButton* ArtworkPage::addColour(QFormLayout& form, const char* name, const QString& label,
                                    QColor ArtworkLayer::*colour) {
    auto* button = new QPushButton;
    button->setObjectName(QLatin1String(name));
    button->setAccessibleName(label);
    connect(button, &QPushButton::clicked, this, [this, name, colour] {
        askColour(artwork_.layers[std::size_t(selected_)].*colour, [this, name,
                                                                    colour](const QColor& chosen) {
            change(QLatin1String(name), [&](ArtworkLayer& layer) { layer.*colour = chosen; });
        });
    });
    form.addRow(label, button);
    return button;
}

void ArtworkPage::makeFields() {
    fields_ = new QWidget;
    form_ = new QFormLayout(fields_);
    form_->setContentsMargins(0, 6, 0, 0);
    form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form_->setRowWrapPolicy(QFormLayout::WrapLongRows);
    text_ = new QPlainTextEdit;
    text_->setObjectName(QStringLiteral("layerText"));
    text_->setAccessibleName(tr("Text"));
    text_->setTabChangesFocus(true);
    text_->setFixedHeight(textHeight);
    connect(text_, &QPlainTextEdit::textChanged, this, [this] {
        change(QStringLiteral("layerText"), [this](ArtworkLayer& layer) {
            layer.text = text_->toPlainText().left(longestLayerText);
        });
    });
    form_->addRow(tr("Text"), text_);
    font_ = new QFontComboBox;
    font_->setObjectName(QStringLiteral("layerFont"));
    font_->setAccessibleName(tr("Font"));
    font_->setMinimumContentsLength(8);
    font_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(font_, &QFontComboBox::currentFontChanged, this, [this](const QFont& font) {
        change(QStringLiteral("layerFont"),
               [&](ArtworkLayer& layer) { layer.font = font.family().left(longestLayerName); });
    });
    form_->addRow(tr("Font"), font_);
    colour_ = addColour(*form_, "layerColour", tr("Colour"), &ArtworkLayer::colour);
    secondColour_ =
        addColour(*form_, "layerSecondColour", tr("Light colour"), &ArtworkLayer::secondColour);
    seed_ = new NumberBox;
    seed_->setDecimals(0);
    seed_->setObjectName(QStringLiteral("layerSeed"));
    seed_->setAccessibleName(tr("Variant"));
    seed_->setToolTip(tr("Each number gives a different pattern of the same kind."));
    seed_->setRange(0, mostSeed);
    seed_->setKeyboardTracking(false);
    connect(seed_, &NumberBox::valueChanged, this, [this] {
        change(QStringLiteral("layerSeed"),
               [&](ArtworkLayer& layer) { layer.seed = seed_->wholeValue(); });
    });
    form_->addRow(tr("Variant"), seed_);
    opacity_ = addNumber(*form_, "layerOpacity", tr("Opacity"),
                         tr("At 100 % the layer hides everything below it."), 0, 100, tr(" %"),
                         [](ArtworkLayer& layer, double value) { layer.opacity = value / 100; });
    makePlaceFields(*form_);
    makeSpotFields(*form_);
}

void ArtworkPage::makeSpotFields(QFormLayout& form) {
    spot_ = new QLineEdit;
    spot_->setObjectName(QStringLiteral("layerSpot"));
    spot_->setAccessibleName(tr("Spot colour"));
    spot_->setPlaceholderText(tr("none"));
    spot_->setToolTip(tr("The name of a varnish or special ink, as the printer knows it. In CMYK "
                         "PDF and TIFF files the layer then becomes a plate of its own. The plate "
                         "uses the layer's shape and opacity, not its colours."));
    spot_->setMaxLength(longestSpotName);
    static const QRegularExpression usable( // not the names that PDF reserves
        QStringLiteral("^(?!\\s*(all|none|cyan|magenta|yellow|black)\\s*$).*$"),
        QRegularExpression::CaseInsensitiveOption);
    spot_->setValidator(new QRegularExpressionValidator(usable, spot_));
    connect(spot_, &QLineEdit::editingFinished, this, [this] {
        const QString name = spot_->text().simplified();
        if (selected_ >= 0 && name != artwork_.layers[std::size_t(selected_)].spot) {
            change(QStringLiteral("layerSpot"), [&](ArtworkLayer& layer) { layer.spot = name; });
        }
    });
    form.addRow(tr("Spot colour"), spot_);
    spotColour_ =
        addColour(form, "layerSpotColour", tr("Display colour"), &ArtworkLayer::spotColour);
    spotColour_->setToolTip(
        tr("Programs and printers that do not know the spot colour use this colour instead."));
    spotFirst_ = new QCheckBox(tr("On the outside"));
    spotFirst_->setObjectName(QStringLiteral("layerSpotFirst"));
    spotFirst_->setToolTip(tr("If ticked, this ink prints before the four process inks and ends up "
                              "on the outside of the part, like a varnish. Otherwise it prints "
                              "after the process inks and lies next to the part."));
    connect(spotFirst_, &QCheckBox::clicked, this, [this](bool isFirst) {
        change(QStringLiteral("layerSpotFirst"),
               [&](ArtworkLayer& layer) { layer.spotFirst = isFirst; });
    });
    form.addRow(QString(), spotFirst_);
}

void ArtworkPage::makePlaceFields(QFormLayout& form) {
    const QString mm = tr(" mm");
    const auto combo = [&](const char* name, const QString& label, const QStringList& words,
                           const std::function<void(ArtworkLayer&, int)>& set) {
        auto* box = new QComboBox;
        box->setObjectName(QLatin1String(name));
        box->setAccessibleName(label);
        box->addItems(words);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(8);
        connect(box, &QComboBox::activated, this, [this, name, set](int index) {
            change(QLatin1String(name), [&](ArtworkLayer& layer) { set(layer, index); });
        });
        form.addRow(label, box);
        return box;
    };
    placement_ =
        combo("layerPlacement", tr("Placement"),
              {tr("As a decal"), tr("Along an axis"), tr("Around an axis"), tr("From six sides")},
              [](ArtworkLayer& layer, int index) { layer.placement = LayerPlacement(index); });
    placement_->setToolTip(tr("A decal keeps lengths and straight lines around its centre. The "
                              "other placements suit patterns that cover the whole part."));
    axis_ = combo("layerAxis", tr("Axis"),
                  {QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z"),
                   QStringLiteral("−X"), QStringLiteral("−Y"), QStringLiteral("−Z")},
                  [](ArtworkLayer& layer, int index) { layer.axis = LayerAxis(index); });
    material_ = combo("layerMaterial", tr("Only on"), {tr("whole part")},
                      [this](ArtworkLayer& layer, int index) {
                          layer.material = index > 0 ? material_->itemText(index) : QString();
                      });
    material_->setToolTip(
        tr("The face of the CAD model, or the material, on which the layer shows. "
           "A decal moves to its middle."));
    const QString within =
        tr("The layer fits into this width and height and keeps its proportions.");
    size_[0] = addNumber(form, "layerWidth", tr("Width"), within, smallestLayer, largestLayer, mm,
                         [](ArtworkLayer& l, double value) { l.size[0] = Millimetres(value); });
    size_[1] = addNumber(form, "layerHeight", tr("Height"), within, smallestLayer, largestLayer, mm,
                         [](ArtworkLayer& l, double value) { l.size[1] = Millimetres(value); });
    shownSize_ = new QLabel;
    shownSize_->setObjectName(QStringLiteral("layerShownSize"));
    shownSize_->setAccessibleName(tr("Printed size"));
    shownSize_->setToolTip(tr("The size of the layer on the part. It keeps its proportions, so it "
                              "can be smaller than the width and height above."));
    form.addRow(tr("Printed size"), shownSize_);
    turn_ = addNumber(form, "layerTurn", tr("Rotation"), tr("Counterclockwise, seen from outside."),
                      -360, 360, tr("°"),
                      [](ArtworkLayer& l, double value) { l.turn = Degrees(value); });
    repeat_ = addNumber(form, "layerRepeat", tr("Repeat width"),
                        tr("The width of one repeat on the part. Around an axis, the width is "
                           "adjusted so that a whole number of repeats fits."),
                        0, largestLayer, mm,
                        [](ArtworkLayer& l, double value) { l.repeat = Millimetres(value); });
    repeat_->setSpecialValueText(tr("no repeat"));
    const std::array<QString, 3> labels{tr("Centre X"), tr("Centre Y"), tr("Centre Z")};
    constexpr std::array<const char*, 3> names{"layerX", "layerY", "layerZ"};
    for (std::size_t k = 0; k < 3; ++k) {
        place_[k] =
            addNumber(form, names[k], labels[k],
                      tr("The layer's centre in the model's coordinates. A decal is centred at the "
                         "nearest place on the surface."),
                      -farthestPlace, farthestPlace, mm,
                      [k](ArtworkLayer& l, double value) { l.place[k] = Millimetres(value); });
        // The farthest place would make the page too wide.
        place_[k]->setMinimumWidth(size_[0]->minimumSizeHint().width());
    }
}

void ArtworkPage::change(const QString& what, const std::function<void(ArtworkLayer&)>& set) {
    if (isShowing_ || selected_ < 0) {
        return;
    }
    ArtworkLayer changed = artwork_.layers[std::size_t(selected_)];
    set(changed);
    emit layerChanged(selected_, changed, what);
}

void ArtworkPage::askColour(const QColor& now, const std::function<void(const QColor&)>& chosen) {
    auto* dialog = new QColorDialog(now, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("layerColourDialog"));
    connect(dialog, &QColorDialog::colorSelected, this, chosen);
    dialog->open();
}

void ArtworkPage::show(const Artwork& artwork, int selected) {
    artwork_ = artwork;
    selected_ = selected < int(artwork.layers.size()) ? selected : -1;
    isShowing_ = true;
    showList();
    showFields();
    isShowing_ = false;
}

int ArtworkPage::rowOf(int layer) const {
    return int(artwork_.layers.size()) - 1 - layer;
}

void ArtworkPage::showList() {
    const int layers = int(artwork_.layers.size());
    while (list_->count() > layers) {
        delete list_->takeItem(list_->count() - 1);
    }
    while (list_->count() < layers) {
        auto* item = new QListWidgetItem(list_);
        item->setFlags(item->flags() | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
    }
    for (int layer = 0; layer < layers; ++layer) {
        const ArtworkLayer& shown = artwork_.layers[std::size_t(layer)];
        QListWidgetItem* item = list_->item(rowOf(layer));
        item->setText(shown.name);
        const QString note = colourNoteOf(shown);
        item->setIcon(note.isEmpty() ? QIcon() : icon(QStringLiteral("warning")));
        item->setToolTip(note);
        item->setCheckState(shown.visible ? Qt::Checked : Qt::Unchecked);
    }
    list_->setCurrentRow(selected_ < 0 ? -1 : rowOf(selected_));
    up_->setEnabled(selected_ >= 0 && selected_ + 1 < layers);
    down_->setEnabled(selected_ > 0);
    remove_->setEnabled(selected_ >= 0);
    hasBase_->setChecked(artwork_.base.has_value());
    base_->setEnabled(artwork_.base.has_value());
    base_->setIcon(artwork_.base ? swatch(*artwork_.base) : QIcon());
    base_->setText(artwork_.base ? artwork_.base->name() : tr("colours of the model"));
}

void ArtworkPage::setMaterials(const QStringList& names) {
    while (material_->count() > 1) {
        material_->removeItem(1);
    }
    if (names.size() > 1) {
        material_->addItems(names);
    }
}

void ArtworkPage::showFields() {
    fields_->setVisible(selected_ >= 0);
    if (selected_ < 0) {
        return;
    }
    const ArtworkLayer& layer = artwork_.layers[std::size_t(selected_)];
    const bool isText = layer.kind == LayerKind::Text;
    const bool isProjected =
        layer.placement == LayerPlacement::Plane || layer.placement == LayerPlacement::Cylinder;
    const bool isEverywhere = layer.placement != LayerPlacement::Decal && layer.repeat.value() > 0;
    const auto showRow = [this](QWidget* field, bool isShown) {
        field->setVisible(isShown);
        form_->labelForField(field)->setVisible(isShown);
    };
    showRow(text_, isText);
    showRow(font_, isText);
    showRow(colour_, layer.kind != LayerKind::Picture);
    showRow(secondColour_, isPattern(layer.kind));
    showRow(seed_, isPattern(layer.kind));
    showRow(axis_, isProjected);
    showRow(material_, material_->count() > 1 || !layer.material.isEmpty());
    showRow(size_[0], !isEverywhere);
    showRow(size_[1], !isEverywhere);
    const bool keepsProportions = layer.repeat.value() <= 0;
    showRow(shownSize_, keepsProportions);
    if (keepsProportions) {
        const std::array<Millimetres, 2> shown = shownSize(layer);
        const auto length = [](Millimetres side) { return numberText(side.value(), 1); };
        shownSize_->setText(tr("%1 × %2 mm").arg(length(shown[0]), length(shown[1])));
    }
    if (text_->toPlainText() != layer.text) { // keeps the cursor where the user types
        text_->setPlainText(layer.text);
    }
    font_->setCurrentFont(QFont(layer.font));
    for (const auto& [button, colour] :
         {std::pair(colour_, layer.colour), std::pair(secondColour_, layer.secondColour),
          std::pair(spotColour_, layer.spotColour)}) {
        button->setIcon(swatch(colour));
        button->setText(colour.name());
    }
    const bool isSpot = !layer.spot.isEmpty();
    spot_->setText(layer.spot);
    showRow(spotColour_, isSpot);
    spotFirst_->setVisible(isSpot);
    spotFirst_->setChecked(layer.spotFirst);
    seed_->setValue(layer.seed);
    opacity_->setValue(100 * layer.opacity);
    placement_->setCurrentIndex(int(layer.placement));
    axis_->setCurrentIndex(int(layer.axis));
    if (!layer.material.isEmpty() && material_->findText(layer.material) < 1) {
        material_->addItem(layer.material); // the model lacks it
    }
    material_->setCurrentIndex(
        layer.material.isEmpty() ? 0 : std::max(material_->findText(layer.material), 0));
    turn_->setValue(layer.turn.value());
    repeat_->setValue(layer.repeat.value());
    for (std::size_t k = 0; k < 2; ++k) {
        size_[k]->setValue(layer.size[k].value());
    }
    for (std::size_t k = 0; k < 3; ++k) {
        place_[k]->setValue(layer.place[k].value());
    }
}

bool ArtworkPage::eventFilter(QObject* watched, QEvent* event) {
    if (watched == list_ && event->type() == QEvent::KeyPress && selected_ >= 0) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool isControl = key->modifiers().testFlag(Qt::ControlModifier);
        if (key->key() == Qt::Key_Delete) {
            emit removeAsked(selected_);
            return true;
        }
        if (key->key() == Qt::Key_Escape) {
            emit selected(-1);
            return true;
        }
        if (isControl && (key->key() == Qt::Key_Up || key->key() == Qt::Key_Down)) {
            emit moveAsked(selected_, key->key() == Qt::Key_Up ? 1 : -1);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace dipwright
