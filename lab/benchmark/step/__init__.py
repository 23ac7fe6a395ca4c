"""The whole controller step: ours against what CasADi generates for the same model."""
