/// Headers of Qt and the standard library that nearly every widget includes, compiled once.
#pragma once

#include <Eigen/Geometry>
#include <QAction>
#include <QApplication>
#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QMainWindow>
#include <QObject>
#include <QPainter>
#include <QPushButton>
#include <QSettings>
#include <QString>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>
