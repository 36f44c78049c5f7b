#include "workbench/project/StartPage.h"

#include "model/ModelFormats.h"
#include "project/Samples.h"
#include "workbench/document/RecentProjects.h"
#include "workbench/widgets/Icons.h"
#include "workbench/widgets/ShippedNames.h"

#include <QAction>
#include <QCommandLinkButton>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QVBoxLayout>

namespace dipwright {

namespace {

constexpr QSize pictureSize(192, 120);
constexpr int sampleRowHeight = pictureSize.height() + 44;
constexpr int actionsWidth = 320;

QIcon projectIcon(const QString& path, const QPalette& palette, double pixelRatio) {
    QPixmap picture(pictureSize * pixelRatio);
    picture.setDevicePixelRatio(pixelRatio);
    picture.fill(palette.color(QPalette::Base));
    QPainter painter(&picture);
    const QImage thumbnail = projectThumbnail(path);
    if (thumbnail.isNull()) {
        const QRect middle(QPoint(), QSize(64, 64));
        icon(QStringLiteral("immersion"))
            .paint(&painter,
                   middle.translated(QRect(QPoint(), pictureSize).center() - middle.center()));
    } else {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(QRect(QPoint(), pictureSize), thumbnail);
    }
    painter.setPen(palette.color(QPalette::Mid));
    painter.drawRect(0, 0, pictureSize.width() - 1, pictureSize.height() - 1);
    return picture;
}

QLabel* makeTitle(const QString& text) {
    auto* title = new QLabel(text);
    QFont bold = title->font();
    bold.setBold(true);
    title->setFont(bold);
    return title;
}

void fill(QListWidget& list, const QStringList& paths, QString (*title)(const QString& name)) {
    list.clear();
    for (const QString& path : paths) {
        const QFileInfo file(path);
        if (file.exists()) {
            auto* item =
                new QListWidgetItem(projectIcon(path, list.palette(), list.devicePixelRatioF()),
                                    title(file.completeBaseName()));
            item->setData(Qt::UserRole, path);
            item->setToolTip(QDir::toNativeSeparators(path));
            list.addItem(item);
        }
    }
}

} // namespace

StartPage::StartPage(QWidget* parent)
    : QWidget(parent), recent_(makeList(tr("Recent projects"), &StartPage::projectChosen)),
      samples_(makeList(tr("Samples"), &StartPage::sampleChosen)),
      recentHint_(new QLabel(tr("Projects that you open or save appear here."))),
      samplesTitle_(makeTitle(tr("Samples"))) {
    setObjectName(QStringLiteral("startPage"));
    setMinimumSize(270, 400); // small, because the view shares this place
    recent_->setContextMenuPolicy(Qt::ActionsContextMenu);
    auto* forget = new QAction(tr("Remove from this list"), recent_);
    connect(forget, &QAction::triggered, this, [this] {
        if (const QListWidgetItem* item = recent_->currentItem()) {
            forgetRecentProject(item->data(Qt::UserRole).toString());
            refresh();
        }
    });
    recent_->addAction(forget);
    samples_->setFixedHeight(sampleRowHeight);
    recentHint_->setWordWrap(true);
    recentHint_->setForegroundRole(QPalette::PlaceholderText);
    auto* right = new QVBoxLayout;
    right->setSpacing(10);
    right->addWidget(samplesTitle_);
    right->addWidget(samples_);
    right->addSpacing(8);
    right->addWidget(makeTitle(tr("Recent projects")));
    right->addWidget(recentHint_);
    right->addWidget(recent_, 1000); // takes all the space when it is shown
    right->addStretch(1);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(40, 32, 32, 20);
    layout->setSpacing(48);
    layout->addWidget(makeActions());
    layout->addLayout(right, 1);
    refresh();
}

QWidget* StartPage::makeActions() {
    auto* column = new QWidget;
    column->setFixedWidth(actionsWidth); // wrapped texts need a fixed width to get their height
    auto* actions = new QVBoxLayout(column);
    actions->setContentsMargins(0, 0, 0, 0);
    auto* logo = new QLabel;
    logo->setPixmap(QIcon(QStringLiteral(":/icons/dipwright.svg")).pixmap(96, 96));
    auto* title = makeTitle(QStringLiteral("Dipwright"));
    QFont large = title->font();
    large.setPointSizeF(large.pointSizeF() * 2.4);
    title->setFont(large);
    auto* subtitle = new QLabel(tr("From a textured model to a printable film."));
    subtitle->setWordWrap(true);
    actions->addWidget(logo);
    actions->addSpacing(4);
    actions->addWidget(title);
    actions->addWidget(subtitle);
    actions->addSpacing(20);
    const auto addButton = [this, actions](const QString& text, const QString& help,
                                           const QString& iconName, void (StartPage::*asked)()) {
        auto* button = new QCommandLinkButton(text, help);
        button->setIcon(icon(iconName));
        button->setIconSize({28, 28});
        button->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
        connect(button, &QCommandLinkButton::clicked, this, asked);
        actions->addWidget(button);
    };
    addButton(tr("New project…"), tr("Start from a textured model: %1.").arg(anyModelFormat()),
              QStringLiteral("document-new"), &StartPage::newAsked);
    addButton(tr("Open project…"), tr("Continue with a saved project."),
              QStringLiteral("document-open"), &StartPage::openAsked);
    addButton(tr("Quick tour"), tr("Explains the window in six steps."), QStringLiteral("help"),
              &StartPage::tourAsked);
    actions->addStretch(1);
    auto* drop = new QLabel(tr("Models and projects can also be dropped on the window."));
    drop->setWordWrap(true);
    drop->setForegroundRole(QPalette::PlaceholderText);
    actions->addWidget(drop);
    return column;
}

QListWidget* StartPage::makeList(const QString& name, void (StartPage::*chosen)(const QString&)) {
    auto* list = new QListWidget(this);
    list->setAccessibleName(name);
    list->setViewMode(QListView::IconMode);
    list->setIconSize(pictureSize);
    list->setGridSize({pictureSize.width() + 24, sampleRowHeight - 8});
    list->setResizeMode(QListView::Adjust);
    list->setMovement(QListView::Static);
    list->setWordWrap(true);
    list->setFrameShape(QFrame::NoFrame);
    list->viewport()->setAutoFillBackground(false);
    connect(list, &QListWidget::itemClicked, list, &QListWidget::itemActivated);
    connect(list, &QListWidget::itemActivated, this, [this, chosen](const QListWidgetItem* item) {
        emit(this->*chosen)(item->data(Qt::UserRole).toString());
    });
    return list;
}

void StartPage::refresh() {
    fill(*recent_, recentProjects(), [](const QString& name) { return name; });
    fill(*samples_, sampleProjects(), shownTitle);
    const bool any = recent_->count() > 0;
    recentHint_->setVisible(!any);
    recent_->setVisible(any);
    samplesTitle_->setVisible(samples_->count() > 0);
    samples_->setVisible(samples_->count() > 0);
}

} // namespace dipwright
