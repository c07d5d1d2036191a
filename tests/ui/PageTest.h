// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QApplication>
#include <QLabel>
#include <QLocale>
#include <QObject>
#include <QPushButton>
#include <QTest>
#include <QWidget>

#include "ui/kit/Actions.h"
#include "ui/kit/Theme.h"

namespace support {

/// Returns the child controls that have no name for a screen reader.
inline QStringList controlsWithoutNames(const QWidget& root)
{
    QStringList found;
    for (const QWidget* widget : root.findChildren<QWidget*>()) {
        const bool isPartOfControl = widget->inherits("QAbstractScrollArea") || widget->inherits("QLineEdit") ||
                                     widget->parentWidget()->inherits("QAbstractItemView");
        if ((widget->focusPolicy() & Qt::TabFocus) != 0 && widget->isVisible() && !isPartOfControl &&
            widget->accessibleName().isEmpty())
            found << widget->metaObject()->className() + QStringLiteral(" ") + widget->objectName();
    }
    return found;
}

/// A base class for tests of one page in a window of its own.
template <class Page>
class PageTest : public QObject
{
protected:
    static void prepare()
    {
        QLocale::setDefault(QLocale("en_GB"));
        ui::kit::applyTheme(*qApp, ui::kit::ThemeChoice::Light);
    }
    void openPage()
    {
        m_window = std::make_unique<QWidget>();
        m_actions = new ui::kit::Actions(m_window.get());
        m_page = new Page(*m_actions, m_window.get());
        for (QWidget* one : {m_window.get(), static_cast<QWidget*>(m_page)})
            one->resize(1280, 800);
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }

    template <class T>
    T* child(const char* name = nullptr) const
    {
        return m_window->findChild<T*>(name == nullptr ? QString() : QString::fromLatin1(name));
    }
    void click(const char* button) const { child<QPushButton>(button)->click(); }
    [[nodiscard]] QString textOf(const char* label) const { return child<QLabel>(label)->text(); }

    std::unique_ptr<QWidget> m_window;
    ui::kit::Actions* m_actions = nullptr;
    Page* m_page = nullptr;
};

}  // namespace support
