"""The controllers: one file each, and one line here."""

from __future__ import annotations

from planners.errors import InputError
from tracking.controllers.controller import Controller
from tracking.controllers.l1 import L1
from tracking.controllers.lqr import Lqr
from tracking.controllers.pure_pursuit import PurePursuit
from tracking.controllers.stanley import Stanley
from tracking.controllers.vector_field import VectorField

ALL_CONTROLLERS: tuple[type[Controller], ...] = (PurePursuit, L1, Stanley, VectorField, Lqr)


def make_controller(name: str) -> Controller:
    """The controller of that name; raises `InputError` for an unknown one."""
    for controller in ALL_CONTROLLERS:
        if controller.name == name:
            return controller()
    known = ", ".join(controller.name for controller in ALL_CONTROLLERS)
    raise InputError("controller", f"there is no controller {name!r}", f"choose one of {known}")
