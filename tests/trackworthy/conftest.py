import pytest

from trackworthy.__main__ import main


@pytest.fixture
def run(capfd):
    """Runs the program; gives exit code, standard output and standard error."""

    def call(*arguments):
        try:
            code = main([str(argument) for argument in arguments])
        except SystemExit as stop:
            code = stop.code
        return (code, *capfd.readouterr())

    return call
